Headers with the same name next to different C files: each file includes its
own.

  $ mkdir a b c
  $ for k in a b c; do
  >   echo "static inline double gain(void) { return $(printf %d "'$k"); }" > $k/gain.h
  >   printf '#include "gain.h"\ndouble of_%s(double x) { return gain() * x; }\n' $k > $k/of_$k.c
  > done
  $ sed 's/^double/extern "C" double/' c/of_c.c > c/of_c.cc
  $ cat > gains.frob <<'F'
  > foreign ofA :: Float -> Float = "of_a"
  > foreign ofB :: Float -> Float = "of_b"
  > foreign ofC :: Float -> Float = "of_c"
  > main :: SF Float (Float, Float, Float)
  > main = proc x -> (ofA x, ofB x, ofC x)
  > F
  $ printf 'time,in\n0,1\n' > in.csv
  $ frobc trace gains.frob --input in.csv --with a/of_a.c --with b/of_b.c --with c/of_c.cc
  time,out.1,out.2,out.3
  0.000000000,97,98,99
  $ frobc trace gains.frob --input in.csv --with c/of_c.cc --with b/of_b.c --with a/of_a.c
  time,out.1,out.2,out.3
  0.000000000,97,98,99

If all files are copied into one folder, one header must be renamed.

  $ cat > drives.frob <<'F'
  > import Robot
  > foreign ofA :: Float -> Float = "of_a"
  > foreign ofB :: Float -> Float = "of_b"
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (proc _ -> roMake (setVelTR (ofA 0 + ofB 0) 0))
  > F
  $ sed -i 's/ofA 0 + ofB 0/(ofA 0 + ofB 0) * 1[m\/s]/' drives.frob
  $ frobc export drives.frob --robot pioneer --platformio out --with a/of_a.c --with b/of_b.c
  error: a/gain.h and b/gain.h have the same name, but an export puts both into one folder: rename one of them
  [2]
  $ cp a/gain.h b/gain.h
  $ frobc export drives.frob --robot pioneer --platformio out --with a/of_a.c --with b/of_b.c && ls out/src/gain.h
  out/src/gain.h

A header that the program names is the same for all C files that include the program's generated
header.

  $ cat > named.frob <<'F'
  > foreign include "gain.h"
  > foreign gain :: () -> Float = "gain"
  > foreign ofB :: Float -> Float = "of_b"
  > main :: SF Float (Float, Float)
  > main = proc x -> (gain (), ofB x)
  > F
  $ echo "static inline double gain(void) { return 98; }" > b/gain.h
  $ frobc trace named.frob --input in.csv --with a/gain.h --with b/of_b.c
  time,out.1,out.2
  0.000000000,97,98
  $ sed -i '1i #include "named.h"' b/of_b.c
  $ frobc trace named.frob --input in.csv --with a/gain.h --with b/of_b.c
  error: b/of_b.c includes the program's generated header, which includes a/gain.h, but the folder of b/of_b.c contains another file with that name, b/gain.h: rename one of them
  [2]
  $ rm b/gain.h && sed -i '1i #pragma once' a/gain.h
  $ frobc trace named.frob --input in.csv --with a/gain.h --with b/of_b.c
  time,out.1,out.2
  0.000000000,97,97
