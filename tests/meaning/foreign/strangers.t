A program from somebody else cannot call arbitrary functions of the C library: the functions that it
calls must be in a given file, or in a header that such a file includes.

  $ cat > shell.frob <<'F'
  > foreign run :: Array 8 Int -> Int = "system"
  > foreign down :: Float -> Float = "floor"
  > main :: SF Float Float
  > main = proc x -> down (toFloat (run [9253987, 0, 0, 0, 0, 0, 0, 0]) + x)
  > F
  $ printf "time,in\n0,27.5\n" > in.csv
  $ frobc trace shell.frob --input in.csv
  error: the program calls `system` in C, but there is no C file: add the C files with `--with FILE.c` (only the functions of <math.h> that docs/foreign.md lists need no file)
  [2]
  $ echo 'double other(double x) { return x; }' > other.c
  $ frobc trace shell.frob --with other.c --input in.csv
  error: the program calls `system` in C, but none of its C files mentions it: add the C files with `--with FILE.c` (only the functions of <math.h> that docs/foreign.md lists need no file)
  [2]

The functions of <math.h> that the docs list need no file. A function defined in a header needs only
the header.

  $ cat > roots.frob <<'F'
  > foreign include "half.h"
  > foreign half :: Float -> Float = "half"
  > foreign down :: Float -> Float = "floor"
  > main :: SF Float Float
  > main = proc x -> half (down x)
  > F
  $ echo 'static inline double half(double x) { return x / 2; }' > half.h
  $ frobc trace roots.frob --with half.h --input in.csv
  time,out
  0.000000000,13.5

A header must be in the folder of its module, or below it.

  $ mkdir below && mv half.h below
  $ include() { sed "s,half.h,$1," roots.frob > outside.frob; frobc check outside.frob 2>&1 | head -3; }
  $ include below/half.h
  $ include ../../secret.h
  error[E0232]: `../../secret.h` is outside this module's folder
   --> outside.frob:1:17
    |
  $ include /etc/passwd
  error[E0232]: `/etc/passwd` is outside this module's folder
   --> outside.frob:1:17
    |

`frobc check` reports names that already have a meaning in C.

  $ named() { printf 'foreign f :: Float -> Float = "%s"\nmain :: SF Float Float\nmain = proc x -> f x\n' $1 > taken.frob; frobc check taken.frob 2>&1 | head -1; }
  $ for name in INFINITY __builtin_trap _Exit int32_t INT32_MAX frob_int_add main bool taken_step taken_reset; do named $name; done
  error[E0232]: `INFINITY` cannot be the C name of your function: it is a keyword, or a macro or type in a C header
  error[E0232]: `__builtin_trap` cannot be the C name of your function: it is reserved by the C standard
  error[E0232]: `_Exit` cannot be the C name of your function: it is reserved by the C standard
  error[E0232]: `int32_t` cannot be the C name of your function: it is a keyword, or a macro or type in a C header
  error[E0232]: `INT32_MAX` cannot be the C name of your function: it is a keyword, or a macro or type in a C header
  error[E0232]: `frob_int_add` cannot be the C name of your function: it is used by the generated C code and its runtime
  error[E0232]: `main` cannot be the C name of your function: it is reserved for the entry point of a C program
  error[E0232]: `bool` is not a name in C
  error[E0431]: the generated C code already has a function `taken_step`
  error[E0431]: the generated C code already has a function `taken_reset`
  $ named mainly
