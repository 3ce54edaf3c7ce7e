A component in C writes beyond its own memory, over the number of the running mode. The controller
runs no other step, and the robot receives a stop.

  $ . ./robot.sh
  $ start_robot
  $ cat > count.h <<'END'
  > #ifndef COUNT_H
  > #define COUNT_H
  > struct count_state { unsigned char last[2]; };
  > #endif
  > END
  $ cat > count.c <<'END'
  > #include "walker.h"
  > void count_reset(struct count_state *self) { self->last[0] = self->last[1] = 0; }
  > void count_step(struct count_state *self, double dt, const struct count_input *in,
  >                 struct count_output *out)
  > {
  >     unsigned char *last = self->last;
  >     (void)dt;
  >     if (in->value > 0.2)
  >         last[0]++;
  >     for (int i = 2; last[0] > 50 && i < 8; i++)
  >         last[i] = 99;
  >     out->value = last[0];
  > }
  > END
  $ cat > walker.frob <<'END'
  > import Robot
  > foreign include "count.h"
  > foreign sf count :: SF Velocity Int = "count"
  > 
  > main :: (HasOdometry i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (walk (count (velocity i))) 0))
  > 
  > walk :: SF Int Velocity
  > walk = switch (proc n -> (0.3[m/s], edge (n > 1000))) (\_ -> constant 0)
  > END
  $ frobc build walker.frob --robot pioneer --with count.c --with count.h -o drive
  $ start_driving; mark; wait $run
  [4]
  $ until_stopped; tail -1 messages
  last speed: 0
  error: the controller found its state damaged: the number of a running mode is invalid; if the program calls C functions, check that they write only to their own memory; sent a stop command to the robot
  $ end_robot
