A program drives the robot; the summary reports the run. (The last digits depend
on the machine.)

  $ sim () { ../../../runtime/frob-sim "$@"; }
  $ world=../../../examples/wall_follow/world.toml
  $ sim ./wall_follower.so --world $world --target 0.5 --for 30 --record one.csv --picture run.svg | sed 's/: [0-9.]* m$/: N m/; s/second: .*/second: N/'
  time simulated: 30.000 s
  distance driven: N m
  wall distance to keep: N m
  mean wall distance error: N m
  largest wall distance error: N m
  odometry error at the end: N m
  collisions: 0
  simulated seconds per second: N
  picture: run.svg
  log: one.csv

The same seed produces the same log, byte for byte; another seed a different
one.

  $ sim ./wall_follower.so --world $world --for 30 --record two.csv > /dev/null
  $ cmp one.csv two.csv
  $ sim ./wall_follower.so --world $world --for 30 --seed 2 --record three.csv > /dev/null
  $ cmp -s one.csv three.csv
  [1]

A replay of the program on its recorded input has the same commands.

  $ ../../../runtime/frob-trace ./wall_follower.so one.csv replayed.csv
  $ sed 's/,.*,\([^,]*,[^,]*\)$/,\1/' one.csv | cmp - replayed.csv

At 30 Hz the instant after 30 steps is at exactly one second.

  $ sim ./wall_follower.so --world $world --for 1 --rate 30 --record rate.csv > /dev/null
  $ tail -1 rate.csv | cut -d, -f1
  1.000000000
  $ sed 1d rate.csv | wc -l | tr -d ' '
  31

A PNG picture is valid, and a picture in an unknown format is rejected.

  $ sim ./wall_follower.so --world $world --for 1 --picture run.png > /dev/null
  $ head -c 4 run.png | tail -c 3; echo
  PNG
  $ sim ./wall_follower.so --world $world --for 1 --picture run.gif
  error: the name of the picture `run.gif` must end in .svg or .png
  [2]

A collision with a wall is reported, and with --strict it is a fault.

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
  >     FROB_PROGRAM_ABI, "ahead", ROBOT, 0, sizeof(struct frob_pioneer_input),
  >     sizeof(struct frob_pioneer_output), NULL, NULL, reset, step, is_valid,
  >     frob_arithmetic_faults };
  > EOF
  $ compile () { gcc -shared -fPIC -I../../../runtime/include "-DROBOT=\"$1\"" ahead.c -o $2; }
  $ compile pioneer ahead.so
  $ sim ./ahead.so --world $world --for 10 | grep collisions
  collisions: 1
  $ sim ./ahead.so --world $world --for 10 --strict > /dev/null
  error: the robot collided with something
  [4]

A program for another robot is rejected.

  $ compile rover rover.so
  $ sim ./rover.so --world $world
  error: there is no simulated rover; for your own robot, define its body `frob_rover_body` in a C file, and add the file with `--with`
  [2]

Wrong use has exit status 2, with a message.

  $ sim ./wall_follower.so
  error: --world is missing; see `frob-sim --help`
  [2]
  $ sim ./wall_follower.so --world missing.toml
  error: missing.toml: there is no such world file
  [2]
  $ sim ./missing.so --world $world 2>&1 | cut -c1-44
  error: ./missing.so is not a compiled progra
  $ sim ./wall_follower.so --world $world --rate fast
  error: --rate takes a number from 0.1 to 10000, not `fast`
  [2]
  $ sim ./wall_follower.so --world $world --speed 3
  error: unknown option `--speed`; `frob-sim --help` lists all options
  [2]
  $ sim ./wall_follower.so --world $world --record no/such/folder.csv
  error: cannot write no/such/folder.csv: No such file or directory
  [2]

All mistakes in a world file are reported together.

  $ cat > wrong.toml <<EOF
  > [start]
  > x = 1
  > heading = 90
  > EOF
  $ sim ./wall_follower.so --world wrong.toml
  error: wrong.toml:1:1: this needs a key `y`
  error: wrong.toml:3:1: unknown key `heading`; did you mean `heading_deg`?
  [2]
