The blob tracker written completely in C, and the one composed of parts, have
the same results.

  $ flags="-std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
  $ cp ../../../examples/blob_tracker/blob* .
  $ awk -f pictures.awk >pictures.csv
  $ trace() { frobc trace blob_tracker.frob --with blob.c --entry $1 --input pictures.csv; }
  $ trace wholeTracker | tee whole
  time,out
  0.000000000,"Blob {column = 0.5, row = 0.5, size = 4}"
  0.100000000,"Blob {column = 1.5, row = 1.5, size = 4}"
  0.200000000,"Blob {column = 2.5, row = 2.5, size = 4}"
  0.300000000,"Blob {column = 3.5, row = 3.5, size = 4}"
  0.400000000,"Blob {column = 4.5, row = 4.5, size = 4}"
  0.500000000,
  0.600000000,
  0.700000000,"Blob {column = 7.5, row = 2.5, size = 4}"
  0.800000000,
  0.900000000,"Blob {column = 3.5, row = 5.5, size = 4}"
  1.000000000,"Blob {column = 6, row = 5.5, size = 2}"
  1.100000000,
  $ trace ofParts | diff whole -

If the window moves along with the blob, the tracker does not lose a blob that becomes faster:

  $ trace leading | tail -3
  0.900000000,"Blob {column = 3.5, row = 5.5, size = 4}"
  1.000000000,"Blob {column = 6, row = 5.5, size = 2}"
  1.100000000,"Blob {column = 9.5, row = 5.5, size = 4}"

  $ trace main | head -3
  time,out
  0.000000000,1
  0.100000000,0.80000000000000004
  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ frobc compile blob_tracker.frob
  $ for cc in gcc clang; do $cc $flags -c blob_tracker.c && $cc $flags -c blob.c; done
  $ g++ -x c++ -std=c++17 ${flags#-std=c99} -c -o out.o blob_tracker.c

  $ unset CPATH

C and C++ call generated C, with several instances at once:

  $ cp ../../../examples/from_c/* .
  $ frobc compile --standalone wheel.frob
  $ gcc $flags -O2 -ffp-contract=off main.c wheel.c -lm -o wheels && ./wheels | tee from_c
  0.0 s, wheel 0: 0.000 m/s, 2.00 V
  0.0 s, wheel 1: 0.000 m/s, 3.20 V
  1.0 s, wheel 0: 0.436 m/s, 5.65 V
  1.0 s, wheel 1: 0.697 m/s, 9.04 V
  2.0 s, wheel 0: 0.527 m/s, 5.22 V
  2.0 s, wheel 1: 0.844 m/s, 8.34 V
  3.0 s, wheel 0: 0.505 m/s, 4.97 V, settled
  3.0 s, wheel 1: 0.808 m/s, 7.95 V
  $ gcc $flags -O2 -ffp-contract=off -c wheel.c
  $ g++ -std=c++17 -O2 ${flags#-std=c99} main.cc wheel.o -lm -o wheels_cc && ./wheels_cc | diff from_c -

The example of docs/foreign.md:

  $ page=../../../docs/foreign.md
  $ block() { awk -v start="\`\`\`$1" -v wanted="$2" '$0 == "```" { inside = 0 } inside && n == wanted; $0 == start { inside = 1; n++ }' $page; }
  $ block frob 1 >smoothing.frob && block c 1 >moving.h && block c 2 >moving.c
  $ frobc compile --standalone smoothing.frob && gcc $flags -c smoothing.c && gcc $flags -c moving.c
  $ printf 'time,in\n0,3\n1,6\n2,9\n3,0\n' >in.csv
  $ frobc trace smoothing.frob --with moving.c --input in.csv
  time,out
  0.000000000,1.75
  1.000000000,2.5
  2.000000000,3.25
  3.000000000,2.5

A header of an older program next to the C file does no harm, and messages of the C compiler name
the user's file:

  $ sed 's/int/long/; s/double/float/' blob_tracker.h > older.h; cmp -s older.h blob_tracker.h && echo same
  [1]
  $ mv older.h blob_tracker.h
  $ trace ofParts | diff whole -
  $ echo 'int f(void) { return g; }' > wrong.c
  $ frobc trace blob_tracker.frob --with blob.c --with wrong.c --entry ofParts --input pictures.csv 2>&1 | grep -o 'wrong.c:1:22: error'
  wrong.c:1:22: error
