The runtime compiles without warnings under clang and gcc (which builds it), in
C99; its headers can be included individually, also from C++.

  $ runtime=../../../runtime
  $ strict="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -I$runtime -I$runtime/include"
  $ for source in $(find $runtime/core $runtime/elementary $runtime/hal/fake $runtime/hal/template $runtime/drivers $runtime/hosts/board -name '*.c'); do
  >   clang -std=c99 $strict -fsyntax-only $source || echo $source
  > done
  $ for source in $(find $runtime/hal/posix $runtime/hosts/robot $runtime/hosts/camera $runtime/hosts/common -name '*.c'); do
  >   clang -std=c99 -D_GNU_SOURCE $strict -fsyntax-only $source || echo $source
  > done
  $ for header in $(cd $runtime; find core hal drivers hosts/board -name '*.h' ! -path 'hal/posix/*' ! -path 'hal/cortex_m/*') ; do
  >   echo "#include \"$header\"" > alone.c
  >   gcc -std=c99 $strict -fsyntax-only alone.c || echo $header
  >   g++ -std=c++17 -x c++ -Wall -Wextra -Wpedantic -Werror -I$runtime -I$runtime/include -fsyntax-only alone.c || echo $header
  > done
