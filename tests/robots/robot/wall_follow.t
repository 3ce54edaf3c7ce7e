The wall follower drives the robot behind the line as in the simulator: along
the wall and round the corner, without touching it.

  $ . ./robot.sh
  $ . ../run/within.sh
  $ follow () {
  >   start_robot --world wall.toml
  >   frobc run ../../../examples/wall_follow/wall_follow.frob --device ./line --for 15s --record log.csv > summary
  >   end_robot
  > }
  $ in_time follow
  $ within distance_driven 3.5 5.5 mean_wall_distance_error 0 0.04 largest_wall_distance_error 0 0.2 odometry_error_at_the_end 0 0.1 collisions 0 0 < served
  $ within connections 1 1 time_run 14.9 16 < summary

It has turned the corner: by odometry, it faces the opposite direction.

  $ awk -F, 'END { print ($4 < -1.2 && $4 > -2) }' log.csv
  1

Its recording replays, bit for bit, in both engines.

  $ frobc trace ../../../examples/wall_follow/wall_follow.frob --input log.csv --output again.csv
  $ sed 's/,.*,\([^,]*,[^,]*\)$/,\1/' log.csv | cmp - again.csv
  $ frobc trace ../../../examples/wall_follow/wall_follow.frob --engine interp --input log.csv | cmp - again.csv
