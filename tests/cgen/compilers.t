The programs made by hand, and their tables for hosts, compile without a warning
as C99 and as C++17.

  $ mkdir c && cd c && ../generate.exe
  $ flags="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -fsyntax-only -I ../../../runtime/include"
  $ gcc -std=c99 $flags *.c
  $ clang -std=c99 $flags *.c
  $ g++ -std=c++17 -x c++ $flags *.c
  $ clang++ -std=c++17 -x c++ $flags *.c

They refuse to compile where numbers would not be IEEE doubles.

  $ gcc -std=c99 -ffast-math -fno-diagnostics-show-caret -fsyntax-only hold.c 2>&1 | grep -o 'compile without.*"'
  compile without -ffast-math"

The same program gives the same text, every time.

  $ mkdir again && cd again && ../../generate.exe && cd ..
  $ for f in *.c *.h; do cmp $f again/$f; done
