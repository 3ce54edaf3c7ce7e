A distance that is computed in two ways is computed once, although one way is in a
function of its own, and from there to here.

  $ cat > near.frob <<'FROB'
  > import Geometry
  > 
  > data Seen = Seen { far :: Distance, atHome, atGate :: Bool }
  > 
  > main :: SF Point2 Seen
  > main = proc here -> Seen { far = norm way, atHome = atHome, atGate = atGate } where
  >     way = home ^-^ here
  >     atHome = isAt home here
  >     atGate = isAt (Vec2 { x = 0, y = 5[m] }) here
  > 
  > home :: Point2
  > home = Vec2 { x = 3[m], y = 1[m] }
  > 
  > isAt :: Point2 -> SF Point2 Bool
  > isAt place = proc p -> seen where
  >     near = distance p place < 0.5[m]
  >     seen = near && not (delay False near) || delay False seen && not (delay True seen) && p.y > 0
  > FROB
  $ frobc compile near.frob
  $ sed -n '/^void near_step/,/^}/p' near.c
  void near_step(struct near_state *self, double dt, const struct near_input *in,
          struct near_output *out)
  {
      (void)dt;
      const double way_x = 3.0 - in->x;                       /* Geometry.frob:26 */
      const double way_y = 1.0 - in->y;
      const double t1 = frob_hypot(way_x, way_y);             /* Geometry.frob:46 */
      const bool atGate = near_isAt_step(&self->isAt_2, in->x, in->y); /* line 9 */
      const bool near = t1 < 0.5;                             /* line 16 */
      const bool atHome = near & !self->near_prev
              || (self->atHome_prev && (!self->atHome_prev_2 && in->y > 0.0)); /* line 17 */
      out->far = t1;                                          /* Geometry.frob:46 */
      out->atHome = atHome;                                   /* line 8 */
      out->atGate = atGate;                                   /* line 9 */
      self->near_prev = near;                                 /* line 17 */
      self->atHome_prev = atHome;
      self->atHome_prev_2 = atHome;
  }
