A named constant of the program keeps its name in C where an operation uses it. The speed that is
passed to `limit` is a literal, because the operation on it is in the library.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > Limits.frob <<'EOF'
  > -- | The slowest speed.
  > slow :: Velocity
  > slow = 0.1[m/s]
  > EOF
  $ cat > follow.frob <<'EOF'
  > import Control
  > import Limits
  > 
  > -- | Turn rate for each metre of error.
  > kSide = -1.2[1/(m s)]
  > 
  > kNear, kFar :: Distance
  > kNear = 30[cm]
  > kFar = 2 * kNear
  > 
  > kGap = 2[1/s]
  > 
  > -- Two names for one number.
  > a, b :: Float
  > a = 7
  > b = 7
  > 
  > main :: SF (Distance, Float) (Velocity, AngularVelocity, Float)
  > main = proc (gap, x) -> (speed, kSide * error + kTurn * integral error, same) where
  >     kTurn = 0.4[1/(m s^2)]
  >     error = gap - kNear
  >     speed = if gap < kNear then slow else if gap > kFar then limit slow (kGap * gap) else 0
  >     same = if x > a then b else if x > 3 then a + x else x * 7
  > EOF
  $ frobc compile follow.frob --lint
  $ grep '^static const' follow.c
  static const double follow_slow = 0.1; /* m/s, Limits.frob:3 */
  static const double follow_k_side = -1.2; /* 1/m/s, line 5 */
  static const double follow_k_near = 0.3; /* m, line 8 */
  static const double follow_k_far = 0.6; /* m, line 9 */
  static const double follow_k_gap = 2.0; /* 1/s, line 11 */
  static const double follow_a = 7.0; /* line 15 */
  static const double follow_b = 7.0; /* line 16 */
  static const double follow_k_turn = 0.4; /* 1/m/s^2, line 20 */
  $ sed -n '/^void follow_step/,$p' follow.c
  void follow_step_ns(struct follow_state *self, int64_t dt_ns, double dt,
          const struct follow_input *in, struct follow_output *out)
  {
      (void)dt_ns;
      dt = frob_dt(dt);
      const double gap = in->f1;
      const double x = in->f2;
      self->error_integral += dt * self->error_integral_input; /* line 19 */
      const double error = gap - follow_k_near;               /* line 21 */
      const double speed = gap < follow_k_near ? follow_slow
              : gap > follow_k_far ? frob_clamp(follow_k_gap * gap, -0.1, 0.1)
              : 0.0; /* line 22 */
      const double same = x > follow_a ? follow_b : x > 3.0 ? follow_a + x : x * 7.0; /* line 23 */
      out->f1 = speed;                                        /* line 22 */
      out->f2 = follow_k_side * error + follow_k_turn * self->error_integral; /* line 19 */
      out->f3 = same;                                         /* line 23 */
      self->error_integral_input = error;                     /* line 19 */
  }
  
  void follow_step(struct follow_state *self, double dt, const struct follow_input *in,
          struct follow_output *out)
  {
      follow_step_ns(self, 0, frob_whole_dt(dt), in, out);
  }

The result has no warnings, and the same machine code as with literals.

  $ flags="-O2 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
  $ gcc -std=c99 $flags -c follow.c && objdump -d follow.o > named
  $ clang -std=c99 $flags -c follow.c -o clang.o
  $ g++ -x c++ -std=c++17 $flags -c follow.c -o cc.o
  $ grep '^static const' follow.c | sed 's/.* \([a-z_]*\) = \([^;]*\);.*/s|\\b\1\\b|\2|g/' > literals
  $ sed -e '/^static const/d' -f literals follow.c > plain.c
  $ grep -c 'follow_k\|follow_slow\|follow_[ab]\b' plain.c
  0
  [1]
  $ gcc -std=c99 $flags -c plain.c -o follow.o && objdump -d follow.o | cmp - named

In single precision, the constant is the float.

  $ frobc compile --real float follow.frob && grep '^static const' follow.c
  static const float follow_slow = 0.1f; /* m/s, Limits.frob:3 */
  static const float follow_k_side = -1.2f; /* 1/m/s, line 5 */
  static const float follow_k_near = 0.3f; /* m, line 8 */
  static const float follow_k_far = 0.6f; /* m, line 9 */
  static const float follow_k_gap = 2.0f; /* 1/s, line 11 */
  static const float follow_a = 7.0f; /* line 15 */
  static const float follow_b = 7.0f; /* line 16 */
  static const float follow_k_turn = 0.4f; /* 1/m/s^2, line 20 */
  $ gcc -std=c99 $flags -Wdouble-promotion -c follow.c
