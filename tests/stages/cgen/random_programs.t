In C, random programs compute bit for bit what the evaluator computes; the code
compiles without warnings.

  $ ./random_c.exe 25 20
  $ flags="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -ffp-contract=off -I ../../../runtime/include"
  $ gcc -std=c99 -O1 $flags *.c ../../../runtime/libfrob.a -lm -o with_gcc && ./with_gcc | diff expected.txt -
  $ clang -std=c99 -O1 $flags *.c ../../../runtime/libfrob.a -lm -o with_clang && ./with_clang | diff expected.txt -

As C++ too:

  $ g++ -std=c++17 -x c++ -fsyntax-only $flags random*.c
  $ clang++ -std=c++17 -x c++ -fsyntax-only $flags random*.c
