Values of every shape can be passed: sums that contain arrays and sums, records with foreign values,
arrays of arrays and of addresses, and values without data.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > camera.h <<'EOF'
  > #ifndef CAMERA_H
  > #define CAMERA_H
  > struct frame { int number; };
  > struct stamp { struct { int set; } flag; double time; };
  > struct count_state { int n; };
  > struct nothing_state { int n; };
  > #endif
  > EOF
  $ cat > shapes.frob <<'EOF'
  > foreign include "camera.h"
  > 
  > foreign type Frame = "struct frame"
  > foreign type Stamp = "struct stamp" copyable
  > 
  > data Eye = LeftEye | RightEye Float | Both (Array 2 Float) Eye2
  > data Eye2 = A | B Int
  > data Rec = Rec { e :: Eye, s :: Stamp, fs :: Array 2 Frame, n :: (Int, ()) }
  > 
  > foreign cal :: Float -> Float = "cal"
  > foreign add :: Float -> Float -> Float = "add2"
  > foreign eye :: Eye -> Maybe Eye = "eye"
  > foreign recf :: Rec -> Rec = "recf"
  > foreign pair :: Array 2 Frame -> Frame = "pair"
  > foreign frames :: Frame -> Array 2 Frame = "frames"
  > foreign grid :: Array 2 (Array 3 Float) -> Array 3 (Array 2 Float) = "grid"
  > foreign unitf :: Float -> () = "unitf"
  > foreign stamp :: Frame -> Stamp = "frame_stamp"
  > foreign sf count :: SF (Frame, Maybe Stamp) (Int, Frame) = "count"
  > foreign sf nothing :: SF () () = "nothing"
  > 
  > main :: SF (Frame, Array 4 Float, Event Frame) (Float, Maybe Eye, Frame, Array 3 (Array 2 Float), Maybe Stamp, Int)
  > main = proc (f, xs, ev) -> (foldl add 0 (map cal xs), eye (Both [1, 2] (B 3)), g, grid [[1,2,3],[4,5,6]], st, k) where
  >     g = pair (frames f)
  >     st = case ev of
  >         Event x -> Just (stamp x)
  >         NoEvent -> before
  >     before = delay Nothing st
  >     r = recf (Rec { e = LeftEye, s = stamp f, fs = frames g, n = (1, ()) })
  >     (k, _) = count (r.fs ! 0, Just r.s)
  >     _u = nothing ()
  >     _z = unitf 3
  > 
  > fed :: SF (Frame, Float) Int
  > fed = proc (f, x) -> n where
  >     n = dSwitch (proc (y, f2) -> (fst (count (f2, Nothing)), edge (y > 5))) (\_ -> proc (y, f2) -> y2 y + fst (count (f2, Nothing))) (toFloat (delay 0 n) + x, f)
  >     y2 y = round y
  > 
  > loopy :: SF (Frame, Float) Float
  > loopy = proc (f, x) -> out where
  >     out = dSwitch (proc (y, _) -> (delay 0 y, edge (y > 5))) (\_ -> proc (y, f2) -> delay 1 y + toFloat (fst (count (f2, Nothing)))) (out + x, f)
  > EOF
  $ flags="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -c -o out.o"
  $ for entry in main fed loopy; do
  >   frobc compile --lint --entry $entry shapes.frob
  >   for cc in gcc clang; do $cc -std=c99 $flags shapes.c; done
  >   for cc in g++ clang++; do $cc -x c++ -std=c++17 $flags shapes.c; done
  > done
  $ sed -n '/^struct frob_eye {/,/^};/p; /^struct frob_rec {/,/^};/p' shapes.h
  struct frob_eye {
      uint8_t tag;
      double f0;
      int32_t i0;
      uint8_t t0;
      struct frob_float_2 float_2_0;
  };
  struct frob_rec {
      struct frob_eye e;
      struct stamp s;
      const struct frame *fs[2];
      struct {
          int32_t f1;
          struct {
              uint8_t unused;
          } f2;
      } n;
  };
  $ grep -E '(recf|pair|frames|grid|unitf|eye)\(' shapes.h
  void eye(const struct frob_eye *a, struct frob_maybe_eye *result);
  void recf(const struct frob_rec *a, struct frob_rec *result);
  const struct frame *pair(const struct pair_a *a);
  void frames(const struct frame *a, struct frames_result *result);
  void grid(const struct grid_a *a, struct grid_result *result);
  void unitf(double a);

If a machine's output is needed before all its inputs are known, the machine first takes a step on a
copy of its state, with the component in it, and then on the state:

  $ grep -B1 'loopy_2_step(&' shapes.c | sed 's, */\*.*,,'
      struct shapes_loopy_2_state trial = self->loopy;
      const double out_2 = shapes_loopy_2_step(&trial, dt, 0.0, f);
      shapes_loopy_2_step(&self->loopy, dt, out_2 + x, f);
  $ sed -n '/: `count`/,/^}/p' shapes.c
  /* count: `count` in the user's C */
  static inline int32_t shapes_count_step(struct count_state *self, double dt,
          const struct frame *a_1, struct frob_maybe_stamp a_2)
  {
      int32_t value = 0;
      if (a_1 != 0) {
          struct count_input in;
          in.f1 = a_1;
          in.f2 = a_2;
          struct count_output out;
          count_step(self, dt, &in, &out);
          value = out.f1;
      }
      return value;
  }

Placeholders for missing values are declared only where a value may be missing.

  $ cat > always.frob <<'EOF'
  > foreign include "camera.h"
  > foreign type Stamp = "struct stamp" copyable
  > foreign sf count :: SF (Maybe Stamp) Int = "count"
  > foreign stamped :: Time -> Stamp = "stamped"
  > main :: SF Time Int
  > main = proc t -> count (Just (stamped t))
  > EOF
  $ frobc compile always.frob && grep -c 'always_no_stamp' always.c
  0
  [1]
  $ for cc in gcc clang; do $cc -std=c99 $flags always.c; done
