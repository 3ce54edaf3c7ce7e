The user's C uses doubles in either precision of the program, so the same files serve both.
Generated code converts the numbers of arguments and results.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cp ../../../examples/blob_tracker/blob* .
  $ awk -f ../foreign/pictures.awk > pictures.csv
  $ trace () { frobc trace --lint blob_tracker.frob --with blob.c --input pictures.csv "$@"; }
  $ for entry in wholeTracker ofParts leading; do
  >   trace --entry $entry > double.csv && trace --entry $entry --real float | diff double.csv - && wc -l < double.csv
  > done
  13
  13
  13
  $ trace --real float | sed -n '2,4p'
  0.000000000,1
  0.100000000,0.8
  0.200000000,0.6

A value that contains numbers has two structs, the program's and C's, and C's is the same in the
headers of programs of both precisions; a value without numbers has one.

  $ cat > seen.frob <<'FROB'
  > data Side = LeftSide | RightSide
  > data Spot = Nowhere | Spot { near :: Distance, sure :: Bool, around :: Array 2 Float, side :: Side }
  > 
  > foreign turned :: Side -> Side = "turned"
  > foreign half :: Distance -> Distance = "half"
  > foreign moved :: Spot -> Array 2 Float -> Spot = "moved"
  > foreign scaled :: Array 3 Float -> Float -> Array 3 Float = "scaled"
  > foreign grid :: (Array 2 (Array 3 Float), Maybe Float) -> (Array 3 (Array 2 Float), Array 2 (Maybe Float)) = "grid"
  > 
  > main :: SF (Distance, Array 3 Float) (Distance, Spot, Array 3 Float, Array 3 (Array 2 Float), Array 2 (Maybe Float))
  > main = proc (d, xs) -> (half d, spot, scaled xs (d / 1[m]), across, maybes) where
  >     spot = moved (Spot { near = d, sure = d > 1[m], around = [xs ! 0, 0.1], side = turned LeftSide }) [xs ! 1, xs ! 2]
  >     (across, maybes) = grid ([xs, [1, 2, d / 1[m]]], Just (xs ! 1))
  > FROB
  $ cat > in_c.c <<'C'
  > #include "seen.h"
  > void turned(const struct frob_side *a, struct frob_side *result)
  > {
  >     result->tag = a->tag == FROB_SIDE_LEFT_SIDE ? FROB_SIDE_RIGHT_SIDE : FROB_SIDE_LEFT_SIDE;
  > }
  > double half(double a) { return a / 2; }
  > void moved(const struct frob_spot *a, const double *b, struct frob_spot *result)
  > {
  >     *result = *a;
  >     result->f0 += b[0];
  >     result->float_2_0.at[1] += b[1];
  > }
  > void scaled(const double *a, double b, double *result)
  > {
  >     for (int i = 0; i < 3; i++)
  >         result[i] = a[i] * b;
  > }
  > void grid(const struct grid_a *a, struct grid_result *result)
  > {
  >     for (int i = 0; i < 2; i++)
  >         for (int j = 0; j < 3; j++)
  >             result->f1[j][i] = a->f1[i][j];
  >     result->f2[0] = a->f2;
  >     result->f2[1].tag = FROB_MAYBE_FLOAT_NOTHING;
  >     result->f2[1].f0 = 0;
  > }
  > C
  $ printf 'time,in.1,in.2[0],in.2[1],in.2[2]\n0,1.5,0.1,0.2,0.3\n1,2,1,2,3\n' > in.csv
  $ frobc trace --lint seen.frob --real float --with in_c.c --input in.csv
  time,out.1,out.2,out.3[0],out.3[1],out.3[2],out.4[0][0],out.4[0][1],out.4[1][0],out.4[1][1],out.4[2][0],out.4[2][1],out.5[0],out.5[1]
  0.000000000,0.75,"Spot {near = 1.7, sure = true, around = [0.1, 0.4], side = RightSide}",0.15,0.3,0.45000002,0.1,1,0.2,2,0.3,1.5,Just 0.2,Nothing
  1.000000000,1,"Spot {near = 4, sure = true, around = [1, 3.1], side = RightSide}",2,4,6,1,1,2,2,3,2,Just 2,Nothing
  $ frobc trace --lint seen.frob --with in_c.c --input in.csv
  time,out.1,out.2,out.3[0],out.3[1],out.3[2],out.4[0][0],out.4[0][1],out.4[1][0],out.4[1][1],out.4[2][0],out.4[2][1],out.5[0],out.5[1]
  0.000000000,0.75,"Spot {near = 1.7, sure = true, around = [0.10000000000000001, 0.40000000000000002], side = RightSide}",0.15000000000000002,0.30000000000000004,0.44999999999999996,0.10000000000000001,1,0.20000000000000001,2,0.29999999999999999,1.5,Just 0.20000000000000001,Nothing
  1.000000000,1,"Spot {near = 4, sure = true, around = [1, 3.1000000000000001], side = RightSide}",2,4,6,1,1,2,2,3,2,Just 2,Nothing

  $ frobc compile seen.frob && sed -n '/^struct frob_spot/,/^}/p; /^double half/p; /^void scaled/p' seen.h > double.txt
  $ frobc compile seen.frob --real float && sed -n '/^struct frob_spot/,/^}/p; /^double half/p; /^void scaled/p' seen.h | diff double.txt -
  $ sed -n '/^struct seen_spot/,/^}/p; /^struct .*side {/,/^}/p' seen.h
  struct frob_side {
      uint8_t tag;
  };
  struct seen_spot {
      uint8_t tag;
      float f0;
      bool b0;
      uint8_t t0;
      struct seen_float_2 float_2_0;
  };
  $ sed -n '/: `half`/,/^}/p; /: `moved`/,/^}/p; /: `scaled`/,/^}/p; /: `turned`/,/^}/p' seen.c
  /* turned: `turned` in the user's C */
  static inline struct frob_side seen_turned(struct frob_side a)
  {
      struct frob_side result;
      turned(&a, &result);
      return result;
  }
  /* moved: `moved` in the user's C */
  static inline struct seen_spot seen_moved(struct seen_spot a, const struct seen_float_2 *b)
  {
      struct seen_spot value;
      struct frob_spot argument1;
      argument1.tag = a.tag;
      argument1.f0 = (double)a.f0;
      argument1.b0 = a.b0;
      argument1.t0 = a.t0;
      for (int32_t i = 0; i < 2; i++) {
          argument1.float_2_0.at[i] = (double)a.float_2_0.at[i];
      }
      double argument2[2];
      for (int32_t i = 0; i < 2; i++) {
          argument2[i] = (double)b->at[i];
      }
      struct frob_spot result;
      moved(&argument1, argument2, &result);
      value.tag = result.tag;
      value.f0 = (float)result.f0;
      value.b0 = result.b0;
      value.t0 = result.t0;
      for (int32_t i = 0; i < 2; i++) {
          value.float_2_0.at[i] = (float)result.float_2_0.at[i];
      }
      return value;
  }
  /* half: `half` in the user's C */
  static inline float seen_half(float a)
  {
      return (float)half((double)a);
  }
  /* scaled: `scaled` in the user's C */
  static inline struct seen_float_3 seen_scaled(const struct seen_float_3 *a, float b)
  {
      struct seen_float_3 value;
      double argument1[3];
      for (int32_t i = 0; i < 3; i++) {
          argument1[i] = (double)a->at[i];
      }
      double result[3];
      scaled(argument1, (double)b, result);
      for (int32_t i = 0; i < 3; i++) {
          value.at[i] = (float)result[i];
      }
      return value;
  }

The code has no warnings in either language.

  $ warnings="-Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Werror"
  $ for file in seen.c in_c.c; do
  >   for cc in gcc clang; do $cc -std=c99 -O2 -ffp-contract=off $warnings -c $file -o out.o || echo $cc $file; done
  > done
  $ for cc in g++ clang++; do $cc -x c++ -std=c++17 $warnings -fsyntax-only seen.c; done
  $ frobc compile blob_tracker.frob --real float
  $ for cc in gcc clang; do $cc -std=c99 $warnings -c blob_tracker.c && $cc -std=c99 $warnings -c blob.c; done
  $ for cc in g++ clang++; do $cc -x c++ -std=c++17 $warnings -fsyntax-only blob_tracker.c; done

A component receives the seconds since its last step, at the program's precision, as a double.
Foreign values, declarations of the C library, and foreign types of unknown contents:

  $ cat > parts.h <<'C'
  > struct lag_state { double last; };
  > struct stamp { double time; };
  > C
  $ cat > parts_program.frob <<'FROB'
  > foreign include "parts.h"
  > foreign type Stamp = "struct stamp" copyable
  > foreign sf lag :: SF (Float, Maybe Stamp) (Float, Time, Maybe Stamp) = "lag"
  > foreign cubeRoot :: Float -> Float = "cbrt"
  > foreign stamped :: Time -> Stamp = "stamped"
  > main :: SF Float (Float, Time, Float, Bool)
  > main = proc x -> (before, dt, cubeRoot x, isJust kept) where
  >     (before, dt, kept) = lag (x, Just (stamped (time ())))
  >     isJust m = case m of
  >         Just _ -> True
  >         Nothing -> False
  > FROB
  $ cat > parts_in_c.c <<'C'
  > #include "parts_program.h"
  > void lag_reset(struct lag_state *self) { self->last = 0; }
  > void lag_step(struct lag_state *self, double dt, const struct lag_input *in, struct lag_output *out)
  > {
  >     out->f1 = self->last;
  >     out->f2 = dt;
  >     out->f3 = in->f2;
  >     self->last = in->f1;
  > }
  > void stamped(double a, struct stamp *result) { result->time = a; }
  > C
  $ printf 'time,in\n0,0.1\n0.3,8\n0.4,27\n' > in.csv
  $ frobc trace --lint parts_program.frob --real float --with parts_in_c.c --with parts.h --input in.csv
  time,out.1,out.2,out.3,out.4
  0.000000000,0,0,0.4641589,true
  0.300000000,0.1,0.3,2,true
  0.400000000,8,0.1,3,true
  $ frobc compile parts_program.frob --real float
  $ for cc in gcc clang; do $cc -std=c99 $warnings -c parts_program.c -o out.o; done
  $ for cc in g++ clang++; do $cc -x c++ -std=c++17 $warnings -fsyntax-only parts_program.c; done

The report counts the conversions, and its stack includes C's structs.

  $ frobc report seen.frob --real float | grep -E 'conversions|calls of'
    conversions              32
    calls of grid             1
    calls of half             1
    calls of moved            1
    calls of scaled           1
  $ frobc report seen.frob | grep -E 'conversions|calls of'
    conversions              0
    calls of grid            1
    calls of half            1
    calls of moved           1
    calls of scaled          1

A robot's program: types that its C shares with the robot's header are those of that header.

  $ cat > drive.frob <<'FROB'
  > import Robot
  > import Geometry
  > 
  > foreign steer :: Distance -> Maybe Distance -> Pose -> AngularVelocity = "steer"
  > 
  > main = reactimateTask (do
  >     driveFor 2[s]
  >     sleepT 1[s] (roMake (setVelTR 0 1[rad/s])))
  > 
  > driveFor t = mkTask (proc i -> (roMake (setVelTR 0.2[m/s] (steer (frontSonar i) (Just (frontSonar i)) (robotPose i))), when (elapsed t ())))
  > FROB
  $ cat > steer.c <<'C'
  > #include "drive.h"
  > double steer(double a, const struct frob_maybe_float *b, const struct frob_pose *c)
  > {
  >     return b->tag == FROB_MAYBE_FLOAT_JUST ? 0.1 * (b->f0 - a) - c->heading : 1.0;
  > }
  > C
  $ for real in float double; do
  >   frobc run drive.frob --robot pioneer --real $real --with steer.c --for 4s | grep -E 'simulated:|driven'
  > done
  time simulated: 4.000 s
  distance driven: 0.400 m
  time simulated: 4.000 s
  distance driven: 0.400 m
  $ frobc build drive.frob --robot pioneer --real float --with steer.c -o drive && test -x drive

A program as a component of another has an interface of doubles if it is compiled in double
precision; the C compiler rejects one with floats.

  $ cat > inner.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> 2 * x
  > FROB
  $ cat > outer.frob <<'FROB'
  > foreign include "inner.h"
  > foreign sf inner :: SF Float Float = "inner"
  > main :: SF Float Float
  > main = proc x -> inner (x + 0.1)
  > FROB
  $ frobc compile inner.frob
  $ frobc trace outer.frob --real float --with inner.c --input in.csv
  time,out
  0.000000000,0.4
  0.300000000,16.2
  0.400000000,54.2
  $ frobc compile inner.frob --real float
  $ frobc trace outer.frob --real float --with inner.c --input in.csv 2>&1 |
  >   grep -o 'conflicting types for .inner_step.' | sort -u
  conflicting types for 'inner_step'

When called from C, a program in single precision takes and returns floats.

  $ cp ../../../examples/from_c/* .
  $ frobc compile wheel.frob --real float
  $ sed -i 's/double/float/g' main.c main.cc
  $ flags="-O2 -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Werror"
  $ gcc -std=c99 $flags main.c wheel.c -lm -o wheels && ./wheels | tee from_c
  0.0 s, wheel 0: 0.000 m/s, 2.00 V
  0.0 s, wheel 1: 0.000 m/s, 3.20 V
  1.0 s, wheel 0: 0.436 m/s, 5.65 V
  1.0 s, wheel 1: 0.697 m/s, 9.04 V
  2.0 s, wheel 0: 0.527 m/s, 5.22 V
  2.0 s, wheel 1: 0.844 m/s, 8.34 V
  3.0 s, wheel 0: 0.505 m/s, 4.97 V, settled
  3.0 s, wheel 1: 0.808 m/s, 7.95 V
  $ gcc -std=c99 $flags -c wheel.c
  $ g++ -std=c++17 $flags main.cc wheel.o -lm -o wheels_cc && ./wheels_cc | diff from_c -
