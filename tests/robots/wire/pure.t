The drivers, and the code through which hosts use them, do not depend on an
operating system: they compile as C99 and C++17 without warnings, use at most a
kilobyte of stack in each function, and call only functions that copy bytes or
are in <math.h>.

  $ runtime=../../../runtime
  $ flags="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wvla -Werror -ffp-contract=off -I$runtime -I$runtime/include"
  $ for source in $runtime/drivers/*/*.c $runtime/core/robot.c; do
  >   gcc -std=c99 $flags -Wstack-usage=1024 -O2 -fno-stack-protector -c $source -o object.o &&
  >   nm -u object.o &&
  >   clang -std=c99 $flags -fsyntax-only $source &&
  >   g++ -x c++ -std=c++17 $flags -fsyntax-only $source ||
  >   echo "in $source"
  > done > symbols
  $ grep '^in ' symbols
  [1]
  $ awk 'NF == 2 && $2 !~ /^frob_/ { print $2 }' symbols | sort -u > called
  $ grep -vxE 'mem(chr|cmp|cpy|move|set)|str(cmp|cpy|len)|_GLOBAL_OFFSET_TABLE_|__assert_fail' called |
  >   grep -vxE 'sin|cos|sincos|atan2|log2|lround|fmin|fmax|fmod|round|floor|ceil'
  [1]
