A program from somebody else cannot reach what the C library can do: what it calls is in a
file that is given, or in a header of the program's own.

  $ cat > shell.frob <<'F'
  > foreign run :: Array 8 Int -> Int = "system"
  > foreign down :: Float -> Float = "floor"
  > main :: SF Float Float
  > main = proc x -> down (toFloat (run [9253987, 0, 0, 0, 0, 0, 0, 0]) + x)
  > F
  $ printf "time,in\n0,27.5\n" > in.csv
  $ frobc trace shell.frob --input in.csv
  error: the program calls `system` in C, and there is no C file: name the C files with `--with FILE.c` (without a file there are only the functions of <math.h> that docs/foreign.md lists)
  [2]
  $ echo 'double other(double x) { return x; }' > other.c
  $ frobc trace shell.frob --with other.c --input in.csv
  error: the program calls `system` in C, which no C file of it mentions: name the C files with `--with FILE.c` (without a file there are only the functions of <math.h> that docs/foreign.md lists)
  [2]

The functions of <math.h> that the docs list need no file; a function of a header needs none either.

  $ cat > roots.frob <<'F'
  > foreign include "half.h"
  > foreign half :: Float -> Float = "half"
  > foreign down :: Float -> Float = "floor"
  > main :: SF Float Float
  > main = proc x -> half (down x)
  > F
  $ echo 'static inline double half(double x) { return x / 2; }' > half.h
  $ frobc trace roots.frob --input in.csv
  time,out
  0.000000000,13.5

A header is in the folder of its module, or below.

  $ mkdir below && mv half.h below
  $ include() { sed "s,half.h,$1," roots.frob > outside.frob; frobc check outside.frob 2>&1 | head -3; }
  $ include below/half.h
  $ include ../../secret.h
  error[E0232]: `../../secret.h` is outside of this module's folder
   --> outside.frob:1:17
    |
  $ include /etc/passwd
  error[E0232]: `/etc/passwd` is outside of this module's folder
   --> outside.frob:1:17
    |

Names that C has a meaning for already are told when a program is checked.

  $ named() { printf 'foreign f :: Float -> Float = "%s"\nmain :: SF Float Float\nmain = proc x -> f x\n' $1 > taken.frob; frobc check taken.frob 2>&1 | head -1; }
  $ for name in INFINITY __builtin_trap _Exit int32_t INT32_MAX frob_int_add main bool taken_step taken_reset; do named $name; done
  error[E0232]: `INFINITY` cannot be a function of yours: it is a macro or a type of C's headers
  error[E0232]: `__builtin_trap` cannot be a function of yours: it is one of those that C compilers keep for themselves
  error[E0232]: `_Exit` cannot be a function of yours: it is one of those that C compilers keep for themselves
  error[E0232]: `int32_t` cannot be a function of yours: it is a macro or a type of C's headers
  error[E0232]: `INT32_MAX` cannot be a function of yours: it is a macro or a type of C's headers
  error[E0232]: `frob_int_add` cannot be a function of yours: it is one of those that generated C and its runtime have
  error[E0232]: `main` cannot be a function of yours: it is where C programs begin
  error[E0232]: `bool` is not a name in C
  error[E0431]: the program's own C has a function `taken_step`
  error[E0431]: the program's own C has a function `taken_reset`
  $ named mainly
