`NAME_step` of a program in single precision receives seconds. The whole seconds are exact; the
fraction is multiplied by 1e9 as a float and rounded to nanoseconds, halves to even.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > slope.frob <<'FROB'
  > main :: SF Float (Float[s], Int)
  > main = proc x -> (integral x, truncate (nanoseconds (time ())))
  > FROB
  $ frobc compile slope.frob --real float --lint
  $ sed -n '/frob_whole_nsf/,/^}/p' $CPATH/frob/step.h
  static inline int64_t frob_whole_nsf(float dt)
  {
      if (!(dt > 0.0f)) {
          return 0;
      }
      if (dt >= 1e9f) {
          return INT64_C(1000000000000000000);
      }
      const int32_t s = (int32_t)dt;
      float ns = (dt - (float)s) * 1e9f;
      if (ns < 8388608.0f) {
          ns = (ns + 8388608.0f) - 8388608.0f;
      }
      return (int64_t)s * 1000000000 + (int32_t)ns;
  }
  $ cat > every.c <<'C'
  > #include "slope.h"
  > #include <math.h>
  > #include <stdio.h>
  > #include <string.h>
  > 
  > static long wrong;
  > 
  > /* The second instant comes this long after the first, and the input was 1 since.
  >  * A step that is given the nanoseconds that are right must do the same. */
  > static void check(float dt)
  > {
  >     struct slope_state a, b;
  >     struct slope_input in = {1.0f};
  >     struct slope_output x, y;
  >     int64_t ns = 0;
  >     if (dt >= 1e9f)
  >         ns = INT64_C(1000000000000000000);
  >     else if (dt > 0.0f)
  >         ns = (int64_t)floorf(dt) * 1000000000 + (int64_t)nearbyintf((dt - floorf(dt)) * 1e9f);
  >     slope_reset(&a);
  >     slope_step(&a, 7.0f, &in, &x);
  >     b = a;
  >     slope_step(&a, dt, &in, &x);
  >     slope_step_ns(&b, ns, (float)ns / 1e9f, &in, &y);
  >     if (memcmp(&a, &b, sizeof a) != 0 || memcmp(&x, &y, sizeof x) != 0)
  >         if (wrong++ == 0) printf("%a: %a, not %a\n", dt, x.f1, y.f1);
  > }
  > 
  > int main(void)
  > {
  >     union { uint32_t bits; float value; } dt;
  >     for (dt.bits = 0; dt.bits < UINT32_C(0xffffff00); dt.bits += 251) check(dt.value);
  >     for (int ns = 0; ns < 20000; ns++) check(((float)ns + 0.5f) / 1e9f);
  >     for (int ns = 8388608; ns < 16777216; ns += 3) check((float)ns / 1e9f);
  >     const float others[] = {0.0f, -0.0f, -1.0f, 0.4e-9f, 0.5e-9f, 1.5e-9f, 1e-45f, 1e9f, 3e38f, INFINITY, -INFINITY, NAN};
  >     for (size_t k = 0; k < sizeof others / sizeof *others; k++) check(others[k]);
  >     printf("%ld wrong\n", wrong);
  > 
  >     struct slope_state state;
  >     struct slope_input in = {1.0f};
  >     struct slope_output out;
  >     slope_reset(&state);
  >     slope_step(&state, 0.0f, &in, &out);
  >     for (int k = 0; k < 10; k++) slope_step(&state, 0.1f, &in, &out);
  >     printf("ten steps of 0.1 s: %d ns\n", (int)out.f2);
  >     return 0;
  > }
  > C
  $ flags="-std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Werror -ffp-contract=off"
  $ for cc in gcc clang; do
  >   for level in -O0 -O3 -Os; do
  >     $cc $flags $level -c slope.c -o slope.o &&
  >     $cc -std=c99 -O1 -ffp-contract=off every.c slope.o -lm -o every && ./every
  >   done
  > done
  0 wrong
  ten steps of 0.1 s: 1000000000 ns
  0 wrong
  ten steps of 0.1 s: 1000000000 ns
  0 wrong
  ten steps of 0.1 s: 1000000000 ns
  0 wrong
  ten steps of 0.1 s: 1000000000 ns
  0 wrong
  ten steps of 0.1 s: 1000000000 ns
  0 wrong
  ten steps of 0.1 s: 1000000000 ns
  $ gcc -std=c99 -O1 -ffp-contract=off -fsanitize=undefined,float-cast-overflow -fno-sanitize-recover=all every.c slope.c -lm -o every && ./every
  0 wrong
  ten steps of 0.1 s: 1000000000 ns
