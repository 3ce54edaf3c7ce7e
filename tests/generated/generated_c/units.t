The comment on each member of the input, the output and the state shows its
unit.

  $ cat > follow.frob <<'EOF'
  > import Control
  > 
  > data Pose = Pose { x :: Distance, heading :: Angle }
  > data Pair[u] = Pair { first :: Float[u], second :: Float[u] }
  > data Field[u] = Field { width :: Float[u], area :: Float[u^2] }
  > data Sensed = Sensed { pose :: Pose, seen :: Event Distance, gap :: Distance, sides :: Pair[m]
  >                      , ranges :: Array 3 Distance, on :: Bool, count :: Int, field :: Field[m] }
  > data Command = Command { speed :: Velocity, turn :: AngularVelocity, share :: Float }
  > 
  > main :: SF Sensed Command
  > main = proc i -> Command { speed = v, turn = turn, share = share / 1[m] } where
  >     gapBefore = delay 0 i.gap
  >     poseBefore = delay Pose { x = 0, heading = 0 } i.pose
  >     v = derivative i.gap + lag 2[s] (i.gap - gapBefore) / 1[s]
  >     turn = (i.pose.heading - poseBefore.heading) / 1[s] + (i.pose.x - poseBefore.x) / 1[m s]
  >     share = integral (integral (i.gap / 1[s^2]))
  > 
  > -- | Is polymorphic in the unit, but `delay` is used in one unit only.
  > lag :: Time -> SF Float[u] Float[u]
  > lag t = proc x -> do
  >     step <- stepTime -< ()
  >     rec let y = before + (x - before) * (step / (t + step))
  >         before <- delay 0 -< y
  >     returnA -< y
  > EOF
  $ frobc compile follow.frob --lint
  $ sed -n '/^struct/,/^}/p' follow.h
  struct follow_event_float {
      uint8_t tag;
      double f0;
  };
  struct follow_pose {
      double x;       /* m */
      double heading; /* rad */
  };
  struct follow_pair {
      double first;
      double second;
  };
  struct follow_field {
      double width;
      double area;
  };
  struct follow_input {
      struct follow_pose pose;
      struct follow_event_float seen; /* m */
      double gap;                     /* m */
      struct follow_pair sides;       /* m */
      double ranges[3];               /* m */
      bool on;
      int32_t count;
      struct follow_field field;
  };
  struct follow_output {
      double speed; /* m/s */
      double turn;  /* rad/s */
      double share;
  };
  struct follow_state {
      double gapBefore;              /* m, delay at follow.frob:12 */
      double poseBefore_x;           /* m, delay at follow.frob:13 */
      double poseBefore_heading;     /* rad, delay at follow.frob:13 */
      double i_gap_derivative;       /* m/s, derivative at follow.frob:14 */
      double i_gap_derivative_input; /* m, previous input at follow.frob:14 */
      double before;                 /* delay at follow.frob:23 */
      double i_gap_integral;         /* m/s, integral at follow.frob:16 */
      double i_gap_integral_input;   /* m/s^2, previous input at follow.frob:16 */
      double share;                  /* m, integral at follow.frob:16 */
      double share_input;            /* m/s, previous input at follow.frob:16 */
      bool started;                  /* true after the first instant at follow.frob:11 */
  };

Components of a tuple, and a value that is not a record:

  $ cat > tuple.frob <<'EOF'
  > main :: SF (Distance, Bool, Float) Float[m/s]
  > main = proc (d, b, x) -> if b then v else x * 1[m/s] where
  >     v = derivative d
  > EOF
  $ frobc compile tuple.frob --lint
  $ sed -n '/^struct/,/^}/p' tuple.h
  struct tuple_input {
      double f1; /* m */
      bool f2;
      double f3;
  };
  struct tuple_output {
      double value; /* m/s */
  };
  struct tuple_state {
      double v;       /* m/s, derivative at tuple.frob:3 */
      double v_input; /* m, previous input at tuple.frob:3 */
      bool started;   /* true after the first instant at tuple.frob:2 */
  };
