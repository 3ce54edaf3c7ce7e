The step rounds dt once, for all modes that use the time. For a mode that has just started, no time
has passed.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > rounds.frob <<'FROB'
  > main :: SF (Bool, Float) Float
  > main = proc i -> either id id (runTask rounds i)
  > 
  > rounds, within :: Task (Bool, Float) Float a
  > rounds = forever (do
  >     mkTask (proc (near, x) -> (x, edge near))
  >     mkTask (proc i -> (either id id (runTask within i), after 1[s] ()))
  >     sleepT 0.25[s] 0
  >     mkTask (proc (near, _) -> (2, edge (not near))))
  > within = forever (do
  >     mkTask (proc (_, x) -> (3, when (x > 1)))
  >     sleepT 0.1[s] 4
  >     mkTask (proc (_, x) -> (5, when (x > 2)))
  >     sleepT 0.05[s] 6)
  > FROB
  $ frobc compile rounds.frob --lint
  $ grep 'dt_ns = ' rounds.c
                  dt_ns = 0;
                  dt_ns = 0;
                  dt_ns = 0;
                  dt_ns = 0;
      int64_t dt_ns = frob_whole_ns(dt);

A dt need not be a whole number of nanoseconds, or a valid time.

  $ awk 'BEGIN {
  >     split("0.02 0.001 0.0300000004 0.25 0.6 0.0000000015", dt)
  >     print "time,in.1,in.2"
  >     for (k = seed = 0; k < 2000; k++) {
  >         seed = (seed * 1103 + 12345) % 65536
  >         printf "%.10f,%s,%g\n", t, seed % 5 < 2 ? "true" : "false", seed % 7 / 2 - 0.5
  >         t += dt[int(seed / 16) % 6 + 1]
  >     }
  > }' > in.csv
  $ frobc trace rounds.frob --input in.csv > out.csv
  $ frobc trace rounds.frob --input in.csv --engine interp | cmp - out.csv
  $ sed 1d out.csv | cut -d, -f2 | sort -n | uniq -c | awk '{ print $2, ($1 > 9 ? "often" : $1) }'
  -0.5 often
  0 often
  0.5 often
  1 often
  1.5 often
  2 often
  2.5 often
  3 often
  4 often
  5 often
  6 often

The step accepts any dt, whichever C compiler is used.

  $ cat > drive.c <<'C'
  > #include "rounds.h"
  > #include <math.h>
  > #include <stdio.h>
  > int main(void)
  > {
  >     const double dt[] = {NAN, -1.0, -0.0, 1.1e-9, 0.2499999990, 0.2500000004, 0.9999999994,
  >                          0.9999999996, 5e6, INFINITY};
  >     for (size_t k = 0; k < sizeof dt / sizeof *dt; k++) {
  >         struct rounds_state state;
  >         const struct rounds_input far = {false, 0.0}, near = {true, 0.0};
  >         struct rounds_output out;
  >         rounds_reset(&state);
  >         rounds_step(&state, dt[k], &far, &out);
  >         rounds_step(&state, dt[k], &near, &out);
  >         rounds_step(&state, dt[k], &near, &out);
  >         printf("%g", out.value);
  >         rounds_step(&state, 1.0, &near, &out);
  >         rounds_step(&state, dt[k], &near, &out);
  >         printf(" %g\n", out.value);
  >     }
  >     return 0;
  > }
  > C
  $ flags="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -ffp-contract=off"
  $ for cc in gcc clang; do
  >     for level in -O0 -O2 -O3 -Os; do
  >         $cc -std=c99 $level $flags drive.c rounds.c -lm -o drive && ./drive > $cc$level
  >         cmp gcc-O0 $cc$level
  >     done
  > done
  $ cat gcc-O0
  3 0
  3 0
  3 0
  3 0
  3 0
  3 2
  3 2
  0 2
  0 2
  0 2
