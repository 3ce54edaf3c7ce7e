Impossible times have the same safe meaning for `NAME_step` and `NAME_step_ns`: NaN and negative
times count as 0, and times above 1e9 s as 1e9 s.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > clock.frob <<'FROB'
  > main :: SF Float (Float[s], Float[1/s], Bool, Time)
  > main = proc x -> (integral x, derivative x, elapsed 7[s] (), time ())
  > FROB
  $ cat > drive.c <<'C'
  > #include "clock.h"
  > #include <math.h>
  > #include <stdio.h>
  > #include <string.h>
  > #ifdef SINGLE
  > typedef float real;
  > #else
  > typedef double real;
  > #endif
  > int main(void)
  > {
  >     const struct { double dt, seconds; int64_t ns; } times[] = {
  >         {0.02, 0.02, 20000000}, {NAN, NAN, 0}, {-1.0, -1.0, -1000000000},
  >         {-INFINITY, -INFINITY, INT64_MIN}, {-0.0, -0.0, 0}, {0.5, 0.5, 500000000},
  >         {1e9, 1e9, INT64_C(1000000000000000000)}, {1e300, 2e9, INT64_C(2000000000000000000)},
  >         {INFINITY, INFINITY, INT64_MAX}, {0.25, 0.25, 250000000},
  >     };
  >     struct clock_state a, b;
  >     clock_reset(&a);
  >     clock_reset(&b);
  >     for (size_t k = 0; k <= sizeof times / sizeof *times; k++) {
  >         const struct clock_input in = {(real)k};
  >         struct clock_output x, y;
  >         const size_t i = k == 0 ? 0 : k - 1;
  >         clock_step(&a, (real)times[i].dt, &in, &x);
  >         clock_step_ns(&b, k == 0 ? 0 : times[i].ns, k == 0 ? 0 : (real)times[i].seconds, &in, &y);
  >         if (memcmp(&x.f1, &y.f1, sizeof x.f1) != 0 || memcmp(&x.f2, &y.f2, sizeof x.f2) != 0 ||
  >             x.f3 != y.f3 || memcmp(&x.f4, &y.f4, sizeof x.f4) != 0)
  >             printf("differs after %g\n", times[i].dt);
  >         printf("%g %g %d %g\n", (double)y.f1, (double)y.f2, y.f3, (double)y.f4);
  >     }
  >     return 0;
  > }
  > C
  $ frobc compile clock.frob
  $ flags="-std=c99 -O1 -ffp-contract=off -Wall -Wextra -Werror -iquote . -fno-sanitize-recover=all"
  $ gcc $flags -fsanitize=undefined,float-cast-overflow clock.c drive.c -lm -o drive && ./drive
  0 0 0 0
  0 50 0 0.02
  0 50 0 0.02
  0 50 0 0.02
  0 50 0 0.02
  0 50 0 0.02
  2.5 2 0 0.52
  6e+09 1e-09 1 1e+09
  1.3e+10 1e-09 1 2e+09
  2.1e+10 1e-09 1 3e+09
  2.1e+10 4 1 3e+09
  $ mkdir single && frobc compile --real float clock.frob -o single && cp drive.c single
  $ cd single && gcc $flags -DSINGLE -fsanitize=undefined,float-cast-overflow clock.c drive.c -lm -o drive && ./drive
  0 0 0 0
  0 50 0 0.02
  0 50 0 0.02
  0 50 0 0.02
  0 50 0 0.02
  0 50 0 0.02
  2.5 2 0 0.52
  6e+09 1e-09 1 1e+09
  1.3e+10 1e-09 1 2e+09
  2.1e+10 1e-09 1 3e+09
  2.1e+10 4 1 3e+09

Modes limit the times that only they use, where they use them. `follow` ignores a negative dt and NaN.
A function subtracts all nanoseconds from the time that is left.

  $ cd .. && mkdir modes && cp drive.c modes && cd modes && cat > clock.frob <<'FROB'
  > main :: SF Float (Float[s], Float[1/s], Bool, Time)
  > main = follow
  > follow, rest, idle :: SF Float (Float[s], Float[1/s], Bool, Time)
  > follow = switch (proc x -> ((0, derivative x, False, 0), after 0.3[s] ())) (\_ -> rest)
  > rest = switch (proc _ -> ((0, 0, True, 0), after 0.1[s] ())) (\_ -> idle)
  > idle = switch (proc x -> ((0, 0, False, 1[s]), edge (x > 8))) (\_ -> follow)
  > FROB
  $ frobc compile clock.frob && grep -o 'frob_[a-z_]*(.*' clock.c | sed 's, */.*,,' | sort -u
  frob_runs_out(&self->modes.rest.time, dt_ns);
  frob_runs_out(&self->modes_2.follow.time, dt_ns);
  frob_short_dt(dt);
  frob_whole_ns(dt) : 0;
  $ gcc $flags -fsanitize=undefined,float-cast-overflow clock.c drive.c -lm -o drive && ./drive
  0 0 0 0
  0 50 0 0
  0 50 0 0
  0 50 0 0
  0 50 0 0
  0 50 0 0
  0 0 1 0
  0 0 0 1
  0 0 0 1
  0 0 0 0
  0 4 0 0
  $ mkdir single && frobc compile --real float clock.frob -o single && cp drive.c single
  $ cd single && gcc $flags -DSINGLE -fsanitize=undefined,float-cast-overflow clock.c drive.c -lm -o drive && ./drive
  0 0 0 0
  0 50 0 0
  0 50 0 0
  0 50 0 0
  0 50 0 0
  0 50 0 0
  0 0 1 0
  0 0 0 1
  0 0 0 1
  0 0 0 0
  0 4 0 0
