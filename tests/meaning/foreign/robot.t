A robot's program calls C like any other program, in the simulator and in the executable for the
robot. Types that it shares with the robot's header are those of that header.

  $ cat > slow.h <<'EOF'
  > struct slow_state { int steps; };
  > EOF
  $ cat > drive.frob <<'EOF'
  > import Robot
  > import Geometry
  > 
  > foreign steer :: Distance -> Maybe Distance -> AngularVelocity = "steer"
  > foreign sf slow :: SF Pose Velocity = "slow"
  > foreign include "slow.h"
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v w) where
  >     v = slow (robotPose i)
  >     f = frontSonar i
  >     w = steer f (if f > 1[m] then Just f else Nothing))
  > EOF
  $ cat > slow.c <<'EOF'
  > #include "drive.h"
  > double steer(double a, const struct frob_maybe_float *b) {
  >     return b->tag == FROB_MAYBE_FLOAT_JUST ? 0.1 * b->f0 : -0.1 * a;
  > }
  > void slow_reset(struct slow_state *self) { self->steps = 0; }
  > void slow_step(struct slow_state *self, double dt, const struct slow_input *in, struct slow_output *out) {
  >     out->value = in->position.x < 0.2 || ++self->steps < 10 ? 0.2 : 0.0 * dt;
  > }
  > EOF
  $ frobc run drive.frob --robot pioneer --with slow.c --with slow.h --for 4s | grep -v 'per second'
  time simulated: 4.000 s
  distance driven: 0.308 m
  odometry error at the end: 0.000 m
  collisions: 0
  $ frobc build drive.frob --robot pioneer --with slow.c --with slow.h -o drive && test -x drive
  $ frobc compile drive.frob --robot pioneer
  $ grep -c 'struct frob_vec2 {' drive.h
  0
  [1]

C may receive the robot's complete input, and return its complete output, in both precisions.

  $ cat > think.frob <<'FROB'
  > import Robot
  > import Pioneer
  > foreign think :: PioneerInput -> Velocity = "think"
  > foreign act :: Velocity -> PioneerOutput = "act"
  > main :: Program PioneerInput PioneerOutput
  > main = reactimateRobot (proc i -> act (think i))
  > FROB
  $ cat > thinks.c <<'C'
  > #include "think.h"
  > #include <string.h>
  > double think(const struct frob_pioneer_input *a)
  > {
  >     return a->odometry.position.x < 0.3 ? 0.2 : 0.0;
  > }
  > void act(double a, struct frob_pioneer_output *result)
  > {
  >     memset(result, 0, sizeof *result);
  >     result->forward = a;
  > }
  > C
  $ for real in double float; do
  >   frobc run think.frob --robot pioneer --real $real --with thinks.c --for 3s | grep distance
  >   frobc compile think.frob --robot pioneer --real $real
  >   for c in "gcc -std=c99" "clang -std=c99" "g++ -x c++ -std=c++17"; do
  >     $c -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -I../../../runtime/include -fsyntax-only think.c
  >   done
  > done
  distance driven: 0.368 m
  distance driven: 0.368 m
