The wall follower drives a user-defined robot behind a line: the driver at one end, the board and
the simulated body at the other.

  $ . ../robot/robot.sh
  $ . ../run/within.sh
  $ rover=../../../examples/own_robot
  $ follow=../../../examples/wall_follow/wall_follow.frob
  $ kind="$rover/Rover.frob --with $rover/rover_body.c --with $rover/rover_board.c"
  $ all=$(printf -- '--with %s ' $rover/*.c)
  $ follow_the_wall () {
  >   start_robot --world ../robot/wall.toml
  >   frobc run $follow --robot $rover/Rover.frob $all --device ./line --for 12s --record log.csv > summary
  >   end_robot
  > }
  $ in_time follow_the_wall
  $ grep robot: summary
  robot: Rover
  $ within distance_driven 1.2 3.5 largest_wall_distance_error 0 0.3 odometry_error_at_the_end 0 0.1 collisions 0 0 < served
  $ within connections 1 1 time_run 11.9 12.2 < summary
  $ frobc trace $follow --robot $rover/Rover.frob --input log.csv --output again.csv
  $ sed 's/,.*,\([^,]*,[^,]*\)$/,\1/' log.csv | cmp - again.csv

Missing parts are named; a robot of the library has no such parts.

  $ frobc serve --robot $rover/Rover.frob --with $rover/rover_body.c --for 1s
  error: there is no `frob_rover_board` in the C files of the robot: define the board of your own robot in a C file, and add the file with `--with`
  [2]
  $ frobc serve --robot scout --with $rover/rover_body.c --for 1s
  error: --with is for your own robot: use it with --robot FILE.frob
  [2]
