A mode needs only its distance from the goal of the place that is handed to it, and the mode
between needs nothing of it: so that is handed on, and it is there anyhow where it begins.

  $ cat > hit.frob <<'FROB'
  > import Geometry
  > 
  > main, toGoal :: SF Point2 Distance
  > main = toGoal
  > toGoal = switch (proc p -> (norm (goal ^-^ p), tag (when (norm (goal ^-^ p) < 1[m])) p)) away
  > 
  > away, back :: Point2 -> SF Point2 Distance
  > away hit = switch (proc p -> (p.x, when (p.y < 0))) (\_ -> back hit)
  > back hit = proc p -> distance p goal - distance hit goal
  > 
  > goal :: Point2
  > goal = Vec2 { x = 3[m], y = 1[m] }
  > FROB
  $ frobc compile hit.frob --lint
  $ grep -h 'hypot' hit.h hit.c
              double hypot_hit; /* parameter at hit.frob:8 */
              double hypot_hit; /* parameter at hit.frob:9 */
      const double t1 = frob_hypot(3.0 - p_x, 1.0 - p_y);     /* Geometry.frob:46 */
  static inline void hit_toGoal_away(double hypot_hit, double p_x, double p_y, double *out_2,
          bool *out_3, double *out_hypot_hit)
      *out_hypot_hit = hypot_hit;                             /* Geometry.frob:46 */
  static inline double hit_toGoal_back(double hypot_hit, double p_x, double p_y)
      return frob_hypot(p_x - 3.0, p_y - 1.0) - hypot_hit;    /* line 9 */
                  self->modes.away.hypot_hit = t3;
              double hypot_hit;
              hit_toGoal_away(self->modes.away.hypot_hit, in->x, in->y, &t1, &t4, &hypot_hit);
                  self->modes.back.hypot_hit = hypot_hit;
              t1 = hit_toGoal_back(self->modes.back.hypot_hit, in->x, in->y);
  $ printf 'time,in.x,in.y\n0,0,0\n1,2.5,1\n2,4,2\n3,3,-1\n4,3,-2\n' > in.csv
  $ frobc trace hit.frob --input in.csv | tee compiled.csv
  time,out
  0.000000000,3.1622776601683795
  1.000000000,2.5
  2.000000000,4
  3.000000000,1.5
  4.000000000,2.5
  $ frobc trace hit.frob --input in.csv --engine interp | diff - compiled.csv
