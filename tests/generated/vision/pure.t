Kernels do not depend on an operating system: they compile as C99 and C++17 without warnings, and
call only functions that copy and compare bytes, square roots, and each other. Their stack use is as
documented in frob/vision.h.

  $ runtime=../../../runtime
  $ flags="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wvla -Werror -ffp-contract=off -I$runtime/include"
  $ for source in $runtime/vision/*.c; do
  >   gcc -std=c99 $flags -O3 -fstack-usage -fno-stack-protector -fno-math-errno -c $source -o object.o && nm -u object.o &&
  >   clang -std=c99 $flags -fsyntax-only $source &&
  >   g++ -x c++ -std=c++17 $flags -fsyntax-only $source &&
  >   clang++ -x c++ -std=c++17 $flags -fsyntax-only $source ||
  >   echo "in $source"
  > done > symbols
  $ grep '^in ' symbols
  [1]
  $ awk 'NF == 2 && $2 !~ /^frob_/ { print $2 }' symbols | sort -u | grep -vxE 'mem(cmp|cpy|move|set)|_GLOBAL_OFFSET_TABLE_'
  [1]
