Three robots in one world run the same program independently. The summary lists each robot, and then
all together. (The last digits depend on the machine.)

  $ sim () { ../../../runtime/frob-sim "$@"; }
  $ cat > three.toml <<EOF
  > [[start]]
  > x = 1
  > y = 1
  > [[start]]
  > x = 3
  > y = 1
  > heading_deg = 90
  > [[start]]
  > x = 5
  > y = 1
  > heading_deg = 180
  > [[wall]]
  > points = [[0, 0], [6, 0], [6, 4], [0, 4]]
  > closed = true
  > [sonar]
  > noise = 0.01
  > EOF
  $ figures () { sed 's/: [0-9.]* m$/: N m/; s/second: .*/second: N/'; }
  $ sim ./wall_follower.so --world three.toml --for 10 --record log.csv --picture run.svg | figures
  robot 1 distance driven: N m
  robot 1 odometry error at the end: N m
  robot 1 collisions: 0
  robot 1 log: log-1.csv
  robot 2 distance driven: N m
  robot 2 odometry error at the end: N m
  robot 2 collisions: 0
  robot 2 log: log-2.csv
  robot 3 distance driven: N m
  robot 3 odometry error at the end: N m
  robot 3 collisions: 0
  robot 3 log: log-3.csv
  robots: 3
  time simulated: 10.000 s
  distance driven: N m
  collisions: 0
  simulated seconds per second: N
  picture: run.svg

Each robot has a log of its inputs and commands, and a replay of it has the same commands.

  $ for k in 1 2 3; do
  >   ../../../runtime/frob-trace ./wall_follower.so log-$k.csv replayed.csv
  >   sed 's/,.*,\([^,]*,[^,]*\)$/,\1/' log-$k.csv | cmp - replayed.csv
  > done
  $ cmp -s log-1.csv log-2.csv
  [1]

The same seed produces the same logs, byte for byte; another seed different
ones.

  $ sim ./wall_follower.so --world three.toml --for 10 --record again.csv > again
  $ for k in 1 2 3; do cmp log-$k.csv again-$k.csv; done
  $ sim ./wall_follower.so --world three.toml --for 10 --seed 2 --record other.csv > other
  $ for k in 1 2 3; do cmp -s log-$k.csv other-$k.csv || echo another; done
  another
  another
  another

If a robot runs into another one, both have collided.

  $ cat > ahead.c <<EOF
  > #include <frob/arithmetic.h>
  > #include <frob/pioneer.h>
  > #include <frob/program.h>
  > static void reset(void *self, const void *params) { (void)self; (void)params; }
  > static bool is_valid(const void *self) { (void)self; return true; }
  > static void step(void *self, const void *params, int64_t dt_ns, double dt, const void *in, void *out)
  > {
  >     struct frob_pioneer_output ahead = { 0.5, 0.0 };
  >     (void)self; (void)params; (void)dt; (void)in;
  >     *(struct frob_pioneer_output *)out = ahead;
  > }
  > const struct frob_program frob_program = {
  >     FROB_PROGRAM_ABI, "ahead", "pioneer", 0, sizeof(struct frob_pioneer_input),
  >     sizeof(struct frob_pioneer_output), NULL, NULL, reset, step, is_valid,
  >     frob_arithmetic_faults };
  > EOF
  $ gcc -shared -fPIC -I../../../runtime/include ahead.c -o ahead.so
  $ cat > towards.toml <<EOF
  > [[start]]
  > x = 0
  > y = 0
  > [[start]]
  > x = 4
  > y = 0
  > heading_deg = 180
  > EOF
  $ sim ./ahead.so --world towards.toml --for 10 --strict > summary
  error: a robot collided with something
  [4]
  $ grep collisions summary
  robot 1 collisions: 1
  robot 2 collisions: 1
  collisions: 2

A thousand robots, as a block.

  $ cat > many.toml <<EOF
  > [start]
  > x = 0
  > y = 0
  > count = 1000
  > spacing = 2
  > EOF
  $ sim ./wall_follower.so --world many.toml --for 0.2 | tail -5 | figures
  robots: 1000
  time simulated: 0.200 s
  distance driven: N m
  collisions: 0
  simulated seconds per second: N
