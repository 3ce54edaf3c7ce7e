A controller with three modes: follow a wall; back up for 1 s after a bump; turn
until the way is clear.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > three_modes.frob <<'EOF'
  > data Sensed = Sensed { bump :: Bool, side :: Distance, front :: Distance }
  > data Command = Command { speed :: Velocity, turn :: AngularVelocity }
  > 
  > follow, backUp, turnAway :: SF Sensed Command
  > follow = switch (proc i -> (steer i, edge i.bump)) (\_ -> backUp)
  > backUp = switch (proc _ -> (Command { speed = -0.2[m/s], turn = 0 }, after 1[s] ())) (\_ -> turnAway)
  > turnAway = switch (proc i -> (Command { speed = 0, turn = 0.8[1/s] }, edge (i.front > 0.6[m]))) (\_ -> follow)
  > 
  > steer :: SF Sensed Command
  > steer = proc i -> Command { speed = 0.3[m/s], turn = 0.8[1/(m s)] * (i.side - 0.5[m]) - 0.3[1/m] * derivative i.side }
  > 
  > main = follow
  > EOF
  $ cat > three_modes.csv <<'EOF'
  > time,in.bump,in.side,in.front
  > 0,false,0.5,2
  > 0.5,false,0.6,1
  > 1,true,0.6,0.1
  > 1.5,true,0.6,0.2
  > 2,false,0.6,0.3
  > 2.5,false,0.6,0.4
  > 3,false,0.6,0.7
  > 3.5,false,0.7,0.7
  > EOF
  $ frobc trace three_modes.frob --input three_modes.csv
  time,out.speed,out.turn
  0.000000000,0.29999999999999999,0
  0.500000000,0.29999999999999999,0.020000000000000004
  1.000000000,-0.20000000000000001,0
  1.500000000,-0.20000000000000001,0
  2.000000000,0,0.80000000000000004
  2.500000000,0,0.80000000000000004
  3.000000000,0.29999999999999999,0.079999999999999988
  3.500000000,0.29999999999999999,0.099999999999999992
  $ frobc trace three_modes.frob --input three_modes.csv --engine interp > other.csv
  $ frobc trace three_modes.frob --input three_modes.csv | cmp - other.csv

In C, the running mode takes a step and its event is tested; only then is an output chosen.

  $ frobc compile three_modes.frob
  $ sed -n '/^struct FROB_OVERLAID three_modes_state/,/^};/p' three_modes.h
  struct FROB_OVERLAID three_modes_state {
      union {
          struct {
              double i_side_derivative;       /* m/s, derivative at three_modes.frob:10 */
              double i_side_derivative_input; /* m, previous input at three_modes.frob:10 */
          } follow;
          struct {
              uint32_t time; /* time left in ns at Prelude.frob:352 */
          } backUp;
          struct {
              bool delay; /* delay at Prelude.frob:382 */
          } turnAway;
      } modes;      /* state of the modes at three_modes.frob:12 */
      uint8_t mode; /* active mode at three_modes.frob:12 */
      union {
          struct {
              bool i_bump_prev; /* delay at Prelude.frob:382 */
          } follow;
      } modes_2;    /* state of the modes at three_modes.frob:12 */
      bool started; /* true after the first instant at three_modes.frob:12 */
  };
  $ sed -n '/^void three_modes_step/,$p' three_modes.c
  void three_modes_step_ns(struct three_modes_state *self, int64_t dt_ns, double dt,
          const struct three_modes_input *in, struct three_modes_output *out)
  {
      double speed = 0.0;
      double turn = 0.0;
      switch (self->mode) {
      case THREE_MODES_FOLLOW: {
          bool t1;
          three_modes_follow_follow_step(self, dt, in->bump, in->side, &speed, &turn, &t1);
          if (t1) {
              self->mode = THREE_MODES_BACK_UP;               /* line 5 */
              three_modes_follow_backUp_reset(self);
              bool t4;
              three_modes_follow_backUp_step(self, 0, &speed, &turn, &t4);
          }
          break;
      }
      case THREE_MODES_BACK_UP: {
          bool t2;
          three_modes_follow_backUp_step(self, dt_ns, &speed, &turn, &t2);
          if (t2) {
              self->mode = THREE_MODES_TURN_AWAY;             /* line 6 */
              three_modes_follow_turnAway_reset(self);
              bool t5;
              three_modes_follow_turnAway_step(self, in->front, &speed, &turn, &t5);
          }
          break;
      }
      default: {                                              /* THREE_MODES_TURN_AWAY */
          bool t3;
          three_modes_follow_turnAway_step(self, in->front, &speed, &turn, &t3);
          if (t3) {
              self->mode = THREE_MODES_FOLLOW;                /* line 7 */
              three_modes_follow_follow_reset(self);
              bool t6;
              three_modes_follow_follow_step(self, 0.0, in->bump, in->side, &speed, &turn, &t6);
          }
          break;
      }
      }
      out->speed = speed;                                     /* line 12 */
      out->turn = turn;
  }
  
  void three_modes_step(struct three_modes_state *self, double dt,
          const struct three_modes_input *in, struct three_modes_output *out)
  {
      int64_t dt_ns = self->started ? frob_whole_ns(dt) : 0;
      self->started = true;
      three_modes_step_ns(self, dt_ns, (double)dt_ns / 1e9, in, out);
  }
  
  bool three_modes_is_valid(const struct three_modes_state *self)
  {
      return self->mode <= THREE_MODES_TURN_AWAY;
  }

The C has no warnings, also for delayed switches and sums.

  $ cat > delayed.frob <<'EOF'
  > main :: SF (Float, Event Float) (Maybe Float, Float)
  > main = proc (x, e) -> drSwitch (proc u -> (Nothing, u)) (x, mapE next e) where
  >     next k = switch (proc u -> ((Just (k + time () / 1[s]), u), edge (u > 3))) (\_ -> proc u -> (Just 0, delay k u))
  > EOF
  $ frobc compile delayed.frob
  $ flags="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
  $ for file in three_modes delayed; do
  >   for level in -O0 -O2; do
  >     gcc -std=c99 $level $flags -c $file.c -o a.o && clang -std=c99 $level $flags -c $file.c -o b.o &&
  >     g++ -std=c++17 -x c++ $level $flags -c $file.c -o c.o && clang++ -std=c++17 -x c++ $level $flags -c $file.c -o d.o
  >   done
  > done
