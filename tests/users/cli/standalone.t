With `--standalone` the two files need nothing but C: they contain the helpers, the elementary
functions and the robot's structs that the program uses.

  $ share=$(dirname "$(command -v frobc)")/../share/frobc lib=$(dirname "$(command -v frobc)")/../lib/frobc
  $ flags="-O1 -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
  $ cat > orbit.frob <<END
  > main :: SF Float (Float, Int)
  > main = proc x -> (sin x + atan2 x (exp x) * log (2 + abs x) + x ** 3, floor (hypot x 3) * 100000 + round x)
  > END
  $ mkdir drive && cat > drive/drive.c <<END
  > #include "orbit.h"
  > #include <stdio.h>
  > int main(void)
  > {
  >     struct orbit_state state;
  >     struct orbit_input in = {0};
  >     struct orbit_output out;
  >     orbit_reset(&state);
  >     for (int i = -3; i < 4; i++) {
  >         in.value = (NUMBER)(1.7 * i);
  >         orbit_step(&state, (NUMBER)0.02, &in, &out);
  >         printf("%a %d\n", (double)out.f1, (int)out.f2);
  >     }
  >     return 0;
  > }
  > END
  $ for real in double float; do
  >   frobc compile orbit.frob --real $real -o with_headers
  >   gcc -std=c99 -DNUMBER=$real $flags -I "$share/include" -iquote with_headers drive/drive.c with_headers/orbit.c "$lib/libfrob.a" -lm -o plain
  >   frobc compile orbit.frob --standalone --real $real
  >   grep -c frob/ orbit.c orbit.h
  >   gcc -std=c99 -DNUMBER=$real $flags -iquote . drive/drive.c orbit.c -lm -o alone && ./plain > expected && ./alone | diff expected - && wc -l < expected
  >   clang -std=c99 $flags -c orbit.c && g++ -x c++ -std=c++17 $flags -c orbit.c && clang++ -x c++ -std=c++17 $flags -c orbit.c
  > done
  orbit.c:0
  orbit.h:0
  7
  orbit.c:0
  orbit.h:0
  7

The files contain exactly what the program needs: compilers report nothing as unused, and nothing as
missing.

  $ cc() { "$@" $flags -c one.c -o one.o && ! nm one.o | grep 'U frob' ; }
  $ for real in double float; do for f in exp log sin cos tan asin acos atan '(2 **)' 'atan2 2' 'hypot 2' sqrt '(2 *)' 'max 1' signum; do
  >   printf 'main :: SF Float Float\nmain = proc x -> %s x\n' "$f" > one.frob
  >   frobc compile one.frob --standalone --real $real
  >   for c in gcc clang; do cc $c -std=c99; done; for c in g++ clang++; do cc $c -std=c++17 -x c++; done
  > done; done
  $ grep -c '^static' one.c
  1

The program's header contains the robot's header, which others may include as
well.

  $ cat > go.frob <<END
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR (min 1[m/s] (frontSonar i * 1[1/s])) 0[rad/s]))
  > END
  $ for robot in pioneer create; do
  >   frobc compile go.frob --standalone --robot $robot && grep '^#include' go.h go.c
  >   printf '#include <frob/%s.h>\n#include "go.h"\n#include <frob/%s.h>\nextern int both;\n' $robot $robot > both.c
  >   gcc -std=c99 $flags -c go.c && gcc -std=c99 $flags -I "$share/include" -c both.c
  > done
  go.h:#include <stdbool.h>
  go.h:#include <stdint.h>
  go.h:#include <stdbool.h>
  go.h:#include <stdint.h>
  go.c:#include "go.h"
  go.c:#include <float.h>
  go.c:#include <math.h>
  go.c:#include <stdbool.h>
  go.c:#include <stdint.h>
  go.c:#include <string.h>
  go.h:#include <stdbool.h>
  go.h:#include <stdint.h>
  go.h:#include <stdbool.h>
  go.h:#include <stdint.h>
  go.c:#include "go.h"
  go.c:#include <float.h>
  go.c:#include <math.h>
  go.c:#include <stdbool.h>
  go.c:#include <stdint.h>
  go.c:#include <string.h>
