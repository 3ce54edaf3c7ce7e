When a mode ends, the code goes directly to the first step of the next one, and skips the rest of
the mode's step, including the machine within it.

  $ cat > duty.frob <<'END'
  > main :: SF (Bool, Float) Float
  > main = rest
  > 
  > rest, work, up, down :: SF (Bool, Float) Float
  > rest = switch (proc (on, _) -> (0, edge on)) (\_ -> work)
  > work = switch (proc i -> (up i, edge (not (fst i)))) (\_ -> rest)
  > up = switch (proc (_, x) -> (integral (x / 1[s]), edge (x < 0))) (\_ -> down)
  > down = switch (proc (_, x) -> (-1, edge (x > 0))) (\_ -> up)
  > END
  $ frobc compile duty.frob --lint
  $ sed -n '/^static.* duty_rest_work_step/,/^}/p' duty.c | sed "s, */\*.*,,"
  static inline void duty_rest_work_step(struct duty_state *self, double dt, bool i_1, double i_2,
          double *out_2, bool *out_3)
  {
      const bool t1 = !i_1 && self->modes_2.work.i_1_prev;
      *out_3 = t1;
      if (!t1) {
          const double t2 = duty_up_step(self, dt, i_2);
          *out_2 = t2;
          self->modes_2.work.i_1_prev = i_1;
      }
  }
  $ printf 'time,in.1,in.2\n0,false,1\n1,true,1\n2,true,2\n3,true,-1\n4,true,3\n5,true,3\n6,false,-1\n7,true,2\n8,true,2\n' > in.csv
  $ frobc trace duty.frob --input in.csv | tee c.csv
  time,out
  0.000000000,0
  1.000000000,0
  2.000000000,1
  3.000000000,-1
  4.000000000,0
  5.000000000,3
  6.000000000,0
  7.000000000,0
  8.000000000,2
  $ frobc trace duty.frob --input in.csv --engine interp | cmp - c.csv

Both ways to end are tested, even if one condition is true whenever the other
one is.

  $ cat > turn.frob <<'END'
  > import Geometry
  > 
  > main, go :: SF (Place, Angle) Float
  > main = go
  > go = switch (proc (p, a) -> (off p a, mergeE (mapE Left (tag (when (p.x > 5)) p)) (tag (when (off p a > 1)) (Right ())))) (either far turned)
  > 
  > type Place = Vec2[1]
  > 
  > off :: Place -> Angle -> Angle
  > off p a = abs (angleDiff (direction p) a)
  > 
  > far :: Place -> SF (Place, Angle) Float
  > far p = proc (q, _) -> q.x - p.x
  > 
  > turned :: () -> SF (Place, Angle) Float
  > turned _ = proc (q, _) -> q.y
  > END
  $ frobc compile turn.frob --lint
  $ sed -n '/^static.* turn_go_/,/^}/p' turn.c | sed "s, */\*.*,,"
  static inline void turn_go_go(const struct turn_input *in, double *out_2, bool *out_3,
          double *out_p_x, bool *out_4)
  {
      const double p_x = in->f1.x;
      const double p_y = in->f1.y;
      const double a = in->f2;
      const bool t1 = p_x > 5.0;
      const double t2 = fabs(turn_wrapAngle(frob_atan2(p_y, p_x) - a));
      const bool t3 = t1 || t2 > 1.0;
      *out_3 = t1;
      *out_p_x = p_x;
      *out_4 = t3;
      if (!(t1 || t3)) {
          *out_2 = t2;
      }
  }
  static inline double turn_go_turned(double q_y)
  {
      return q_y;
  }
  static inline double turn_go_far(double p_x, double q_x)
  {
      return q_x - p_x;
  }
  $ printf 'time,in.1.x,in.1.y,in.2\n0,3,0.1,0\n1,4,0,0.5\n2,7,-1,3\n3,8,2,0\n' > in.csv
  $ frobc trace turn.frob --input in.csv | tee c.csv
  time,out
  0.000000000,0.033320995878247196
  1.000000000,0.5
  2.000000000,0
  3.000000000,1
  $ frobc trace turn.frob --input in.csv --engine interp | cmp - c.csv
  $ sed -i 's/,7,-1,3/,4,-1,3/' in.csv
  $ frobc trace turn.frob --input in.csv | tee c.csv
  time,out
  0.000000000,0.033320995878247196
  1.000000000,0.5
  2.000000000,-1
  3.000000000,2
  $ frobc trace turn.frob --input in.csv --engine interp | cmp - c.csv

The same if one way to end is taken only if the other one's condition is also true.

  $ cat > both.frob <<'END'
  > main, go :: SF (Bool, Float) Float
  > main = go
  > go = switch (proc (on, x) -> (integral (x / 1[s]), mergeE (tag (when (x > 5 && on)) (Left ())) (tag (when (x > 5)) (Right x)))) (either (\_ -> rest (-1)) rest)
  > 
  > rest :: Float -> SF (Bool, Float) Float
  > rest y = switch (proc (on, _) -> (y, edge on)) (\_ -> go)
  > END
  $ frobc compile both.frob --lint
  $ sed -n '/^static.* both_go_go_step/,/^}/p' both.c | sed "s, */\*.*,,"
  static inline void both_go_go_step(struct both_state *self, double dt, bool on, double x,
          double *out_2, bool *out_3, bool *out_4, double *out_x)
  {
      dt = frob_dt(dt);
      self->modes.go.x_integral += dt * self->modes.go.x_integral_input;
      const bool t1 = x > 5.0;
      const bool t2 = t1 && on;
      *out_3 = t2;
      *out_4 = t1;
      *out_x = x;
      if (!(t2 || t1)) {
          *out_2 = self->modes.go.x_integral;
          self->modes.go.x_integral_input = x;
      }
  }
  $ printf 'time,in.1,in.2\n0,false,1\n1,true,1\n2,true,6\n3,false,7\n4,false,8\n5,true,3\n6,false,6\n7,true,2\n8,true,2\n' > in.csv
  $ frobc trace both.frob --input in.csv | tee c.csv
  time,out
  0.000000000,0
  1.000000000,1
  2.000000000,-1
  3.000000000,-1
  4.000000000,-1
  5.000000000,0
  6.000000000,6
  7.000000000,0
  8.000000000,2
  $ frobc trace both.frob --input in.csv --engine interp | cmp - c.csv
