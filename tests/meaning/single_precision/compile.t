With `--real float` each number is a C float: members, parameters, literals,
functions. Time is counted in whole nanoseconds; a step receives nanoseconds or
seconds.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > cruise.frob <<EOF
  > import Control
  > 
  > data Speeds = Speeds { wanted :: Velocity, measured :: Velocity }
  > 
  > main :: SF Speeds (Float[V], Int)
  > main = proc s -> (limit 12[V] (4.1[V s/m] * error + 2[V/m] * integral error), round (sin (error / 1[m/s]))) where
  >     error = s.wanted - s.measured
  > EOF
  $ frobc compile cruise.frob --real float
  $ sed -n '/^struct/,$p' cruise.h
  struct cruise_input {
      float wanted;   /* m/s */
      float measured; /* m/s */
  };
  
  struct cruise_output {
      float f1;   /* V */
      int32_t f2;
  };
  
  struct cruise_state {
      float error_integral;       /* m, integral at cruise.frob:6 */
      float error_integral_input; /* m/s, previous input at cruise.frob:6 */
  };
  
  void cruise_reset(struct cruise_state *self);
  
  void cruise_step_ns(struct cruise_state *self, int64_t dt_ns, float dt,
          const struct cruise_input *in, struct cruise_output *out);
  
  void cruise_step(struct cruise_state *self, float dt, const struct cruise_input *in,
          struct cruise_output *out);
  
  #ifdef __cplusplus
  }
  #endif
  #endif
  $ sed -n '/cruise_reset/,$p' cruise.c
  void cruise_reset(struct cruise_state *self)
  {
      self->error_integral = 0.0f;                            /* line 6 */
      self->error_integral_input = 0.0f;
  }
  
  void cruise_step_ns(struct cruise_state *self, int64_t dt_ns, float dt,
          const struct cruise_input *in, struct cruise_output *out)
  {
      (void)dt_ns;
      dt = frob_dtf(dt);
      self->error_integral += dt * self->error_integral_input; /* line 6 */
      const float error = in->wanted - in->measured;          /* line 7 */
      out->f1 = frob_clampf(4.1f * error + 2.0f * self->error_integral, -12.0f, 12.0f); /* Control.frob:15 */
      out->f2 = frob_roundf(frob_sinf(error));                /* line 6 */
      self->error_integral_input = error;
  }
  
  void cruise_step(struct cruise_state *self, float dt, const struct cruise_input *in,
          struct cruise_output *out)
  {
      int64_t dt_ns = frob_whole_nsf(dt);
      cruise_step_ns(self, dt_ns, (float)dt_ns / 1e9f, in, out);
  }

The C contains no doubles, and has no warnings.

  $ grep -c double cruise.h cruise.c
  cruise.h:0
  cruise.c:0
  [1]
  $ warnings="-Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Werror"
  $ headers="-I ../../../runtime/include"
  $ gcc -std=c99 -O2 -ffp-contract=off $warnings $headers -c cruise.c
  $ clang -std=c99 -O2 -ffp-contract=off $warnings $headers -c cruise.c
  $ g++ -x c++ -std=c++17 $warnings $headers -fsyntax-only cruise.c
  $ clang++ -x c++ -std=c++17 $warnings $headers -fsyntax-only cruise.c

Nanoseconds are exact; seconds are rounded to nanoseconds.

  $ cat > time.frob <<EOF
  > main :: SF () (Bool, Time)
  > main = proc _ -> (elapsed 7[s] (), time ())
  > EOF
  $ frobc compile time.frob --real float
  $ cat > steps.c <<EOF
  > #include "time.h"
  > #include <math.h>
  > #include <stdio.h>
  > static struct time_state a, b;
  > static void both(int64_t dt_ns, float dt)
  > {
  >     struct time_input in = { 0 };
  >     struct time_output x, y;
  >     time_step_ns(&a, dt_ns, (float)dt_ns / 1e9f, &in, &x);
  >     time_step(&b, dt, &in, &y);
  >     printf("%d %.9g, %d %.9g\n", x.f1, (double)x.f2, y.f1, (double)y.f2);
  > }
  > int main(void)
  > {
  >     time_reset(&a);
  >     time_reset(&b);
  >     both(0, 0.7f);
  >     for (int i = 0; i < 10; i++) both(700000000, 0.7f);
  >     both(1000000, 0.001f);
  >     both(INT64_MIN, -1.0f);
  >     both(-1, (float)NAN);
  >     both(INT64_MAX, INFINITY);
  >     return 0;
  > }
  > EOF
  $ gcc -std=c99 -O1 -g -fsanitize=undefined,float-cast-overflow $warnings -iquote . $headers steps.c time.c -lm -o steps
  $ ./steps
  0 0, 0 0
  0 0.699999988, 0 0.699999988
  0 1.39999998, 0 1.39999998
  0 2.0999999, 0 2.0999999
  0 2.79999995, 0 2.79999995
  0 3.5, 0 3.5
  0 4.19999981, 0 4.19999981
  0 4.89999962, 0 4.89999962
  0 5.5999999, 0 5.5999999
  0 6.30000019, 0 6.30000019
  1 7, 1 7
  1 7.00099993, 1 7.00099993
  1 7.00099993, 1 7.00099993
  1 7.00099993, 1 7.00099993
  1 1e+09, 1 1e+09

Literals have the fewest digits that read back as the same float, and are rounded once: the third
exceeds the midpoint between two floats by less than a double can represent.

  $ cat > literals.frob <<EOF
  > main :: SF () (Float, Float, Float, Float, Float, Float, Float)
  > main = proc _ -> (1.00000005960464477539, 1.00000005960464477540, 1.00000005960464477539062500001, 0.1, 1.0e-45, 1 / 3, 16777217)
  > EOF
  $ frobc compile literals.frob --real float && grep 'out->' literals.c
      out->f1 = 1.0f;                                         /* line 2 */
      out->f2 = 1.0000001f;
      out->f3 = 1.0000001f;
      out->f4 = 0.1f;
      out->f5 = 1e-45f;
      out->f6 = 0.33333334f;
      out->f7 = 16777216.0f;

Numbers that are out of range are reported.

  $ cat > huge.frob <<EOF
  > main :: SF Float Float
  > main = proc x -> x + 1.0e39
  > EOF
  $ frobc check huge.frob
  $ frobc check huge.frob --real float
  error[E0315]: the number `1.0e39` is out of range
   --> huge.frob:2:22
    |
  2 | main = proc x -> x + 1.0e39
    |                      ^^^^^^
    |
    = note: with `--real float`, the largest number is 3.4028234663852886e38
  
  1 error
  [1]
