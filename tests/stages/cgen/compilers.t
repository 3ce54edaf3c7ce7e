The hand-built programs and their tables for hosts compile without warnings as
C99 and as C++17.

  $ mkdir c && cd c && ../generate.exe
  $ flags="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -fsyntax-only -I ../../../../runtime/include"
  $ gcc -std=c99 $flags *.c
  $ clang -std=c99 $flags *.c
  $ g++ -std=c++17 -x c++ $flags *.c
  $ clang++ -std=c++17 -x c++ $flags *.c

They do not compile if numbers would not be IEEE doubles.

  $ refused () { "$@" -std=c99 $flags hold.c 2>&1 | grep -o 'error:.*compile without.*"'; }
  $ for option in -ffast-math -ffinite-math-only -freciprocal-math -fno-signed-zeros; do refused gcc $option; done
  error: #error "the program needs IEEE 754 arithmetic: compile without -ffast-math and its suboptions"
  error: #error "the program needs IEEE 754 arithmetic: compile without -ffast-math and its suboptions"
  error: #error "the program needs IEEE 754 arithmetic: compile without -ffast-math and its suboptions"
  error: #error "the program needs IEEE 754 arithmetic: compile without -ffast-math and its suboptions"
  $ refused clang -ffast-math
  error: "the program needs IEEE 754 arithmetic: compile without -ffast-math and its suboptions"
  $ refused clang -ffinite-math-only
  error: "the program needs IEEE 754 arithmetic: compile without -ffast-math and its suboptions"

The generated text is the same every time.

  $ mkdir again && cd again && ../../generate.exe && cd ..
  $ for f in *.c *.h; do cmp $f again/$f; done
