A long line is broken at the loosest-binding operators. If an operand needs more than one line,
every operator next to it begins a line, so that a reader does not overlook it.

  $ cat > far.frob <<'FROB'
  > main :: SF (Distance, Distance, Distance, Distance) (Bool, Distance, Distance)
  > main = proc (behindTheRobot, besideTheRobot, beforeTheRobot, aboveTheRobot) -> (moved, chosen, part) where
  >     moved = hypot (behindTheRobot - besideTheRobot) (beforeTheRobot - aboveTheRobot * 3) > 0.5[m]
  >         || hypot (besideTheRobot - beforeTheRobot) (behindTheRobot - aboveTheRobot) + 0.25[m] < behindTheRobot
  >     chosen = if behindTheRobot > besideTheRobot then behindTheRobot * 2 + besideTheRobot
  >         else if besideTheRobot > beforeTheRobot then beforeTheRobot * 3 - aboveTheRobot else aboveTheRobot
  >     part = behindTheRobot * 1.5 + besideTheRobot * 2.5 + beforeTheRobot * 3.5 - aboveTheRobot * 4.5
  > FROB
  $ frobc compile far.frob
  $ sed -n '/^void far_step/,$p' far.c
  void far_step_ns(struct far_state *self, int64_t dt_ns, double dt, const struct far_input *in,
          struct far_output *out)
  {
      (void)self;
      (void)dt_ns;
      (void)dt;
      const double behindTheRobot = in->f1;
      const double besideTheRobot = in->f2;
      const double beforeTheRobot = in->f3;
      const double aboveTheRobot = in->f4;
      const bool moved =
              frob_hypot(behindTheRobot - besideTheRobot, beforeTheRobot - aboveTheRobot * 3.0)
                      > 0.5
                  || frob_hypot(besideTheRobot - beforeTheRobot, behindTheRobot - aboveTheRobot)
                          + 0.25
                      < behindTheRobot; /* line 3 */
      const double chosen =
              besideTheRobot < behindTheRobot ? behindTheRobot * 2.0 + besideTheRobot
                  : beforeTheRobot < besideTheRobot ? beforeTheRobot * 3.0 - aboveTheRobot
                  : aboveTheRobot; /* line 5 */
      const double part = behindTheRobot * 1.5 + besideTheRobot * 2.5 + beforeTheRobot * 3.5
              - aboveTheRobot * 4.5; /* line 7 */
      out->f1 = moved;                                        /* line 3 */
      out->f2 = chosen;                                       /* line 5 */
      out->f3 = part;                                         /* line 7 */
  }
  
  void far_step(struct far_state *self, double dt, const struct far_input *in,
          struct far_output *out)
  {
      (void)dt;
      far_step_ns(self, 0, 0.0, in, out);
  }
