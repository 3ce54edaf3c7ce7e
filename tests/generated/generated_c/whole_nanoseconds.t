`NAME_step` rounds dt to whole nanoseconds. If the step only needs seconds, dt is almost always
already the double nearest to a whole number of nanoseconds, which a test of its bits detects. The
result always equals rounding followed by one division.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > slope.frob <<'FROB'
  > main :: SF Float (Float[s], Float[1/s])
  > main = proc x -> (integral x, derivative x)
  > FROB
  $ frobc compile slope.frob --lint
  $ sed -n '/^void slope_step/,$p' slope.c
  void slope_step_ns(struct slope_state *self, int64_t dt_ns, double dt,
          const struct slope_input *in, struct slope_output *out)
  {
      (void)dt_ns;
      dt = frob_dt(dt);
      const double x = in->value;
      self->x_integral += dt * self->x_integral_input;        /* line 2 */
      if (dt > 0.0) {
          self->x_derivative = (x - self->x_derivative_input) / dt;
      }
      self->x_derivative_input = x;
      out->f1 = self->x_integral;
      out->f2 = self->x_derivative;
      self->x_integral_input = x;
  }
  
  void slope_step(struct slope_state *self, double dt, const struct slope_input *in,
          struct slope_output *out)
  {
      dt = self->started ? dt : 0.0;
      self->started = true;
      slope_step_ns(self, 0, frob_whole_dt(dt), in, out);
  }
  $ cat > every.c <<'C'
  > #include "slope.h"
  > #include <math.h>
  > #include <stdio.h>
  > #include <string.h>
  > 
  > static long wrong;
  > 
  > /* The second instant comes this long after the first, and the input was 1 since. */
  > static void check(double dt)
  > {
  >     const double ns = dt > 0.0 ? nearbyint((dt < 1e9 ? dt : 1e9) * 1e9) : 0.0;
  >     const double expected = ns / 1e9;
  >     struct slope_state state;
  >     struct slope_input in = {1.0};
  >     struct slope_output out;
  >     slope_reset(&state);
  >     slope_step(&state, 7.0, &in, &out);
  >     if (out.f1 != 0.0 || out.f2 != 0.0) wrong++;
  >     in.value = 2.0;
  >     slope_step(&state, dt, &in, &out);
  >     if (memcmp(&out.f1, &expected, sizeof expected) != 0
  >         || out.f2 != (expected > 0.0 ? 1.0 / expected : 0.0)) {
  >         if (wrong++ == 0) printf("%a: %a, not %a\n", dt, out.f1, expected);
  >     }
  > }
  > 
  > static double random_number(void)
  > {
  >     static uint64_t state = UINT64_C(0x9e3779b97f4a7c15);
  >     state ^= state << 13;
  >     state ^= state >> 7;
  >     state ^= state << 17;
  >     return (double)(state >> 11) / 9007199254740992.0;
  > }
  > 
  > static void check_around(double dt)
  > {
  >     double up = dt, down = dt;
  >     for (int k = 0; k < 4; k++) {
  >         check(up);
  >         check(down);
  >         up = nextafter(up, INFINITY);
  >         down = nextafter(down, -INFINITY);
  >     }
  > }
  > 
  > int main(void)
  > {
  >     for (int exponent = -40; exponent < 32; exponent++) {
  >         check_around(ldexp(1.0, exponent));
  >         for (int k = 0; k < 4000; k++) {
  >             const double dt = ldexp(1.0 + random_number(), exponent);
  >             const double ns = floor(dt * 1e9);
  >             check(dt);
  >             check_around(ns / 1e9);
  >             check_around((ns + 0.25) / 1e9);
  >             check_around((ns + 0.5) / 1e9);
  >         }
  >     }
  >     for (int ns = 0; ns < 100000; ns++) check(ns / 1e9);
  >     const double others[] = {0.0, -0.0, -1.0, -0.02, 5e-324, 4.5e15, 1e300, INFINITY, -INFINITY, NAN};
  >     for (size_t k = 0; k < sizeof others / sizeof *others; k++) check(others[k]);
  >     printf("%ld wrong\n", wrong);
  >     return 0;
  > }
  > C
  $ flags="-std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
  $ for cc in gcc clang; do
  >   for level in -O0 -O2 -O3 -Os; do
  >     $cc $flags $level -ffp-contract=off -c slope.c -o slope.o &&
  >     $cc -std=c99 -D_DEFAULT_SOURCE -O1 every.c slope.o -lm -o every && ./every
  >   done
  > done
  0 wrong
  0 wrong
  0 wrong
  0 wrong
  0 wrong
  0 wrong
  0 wrong
  0 wrong
  $ g++ -x c++ -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -c slope.c -o slope.o
  $ gcc -std=c99 -fsanitize=undefined -fno-sanitize-recover=all every.c slope.c -lm -o every && ./every
  0 wrong
