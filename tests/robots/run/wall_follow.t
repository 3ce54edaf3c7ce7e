The wall follower goes once round its room in a minute, touches nothing and
keeps its distance.

  $ . ./within.sh
  $ examples=../../../examples
  $ frobc run $examples/wall_follow/wall_follow.frob --world $examples/wall_follow/world.toml --for 60s --seed 1 --record one.csv --picture run.png > summary
  $ within time_simulated 60 60 distance_driven 17 20 wall_distance_to_keep 0.2 0.2 mean_wall_distance_error 0 0.03 largest_wall_distance_error 0 0.2 odometry_error_at_the_end 0 0.3 collisions 0 0 < summary
  $ sed 1,8d summary
  picture: run.png
  log: one.csv
  $ head -c 4 run.png | tail -c 3; echo
  PNG

Once round: at the end the robot is near the place where it started, after
having been in the corner of the room farthest from it (by odometry, which
starts at 0).

  $ awk -F, 'NR > 1 { if ($2 > x) x = $2; if ($3 < y) y = $3; end_x = $2; end_y = $3 }
  >   END { print (x > 4.5 && x < 5.2), (y < -3 && y > -4), (end_x * end_x + end_y * end_y < 1) }' one.csv
  1 1 1

The default world is the one next to the program; the same seed produces the
same log, byte for byte, and another seed a different one.

  $ frobc run $examples/wall_follow/wall_follow.frob --record two.csv > /dev/null
  $ cmp one.csv two.csv
  $ frobc run $examples/wall_follow/wall_follow.frob --seed 2 --record three.csv > /dev/null
  $ cmp -s one.csv three.csv
  [1]

`frobc trace` accepts the recording as input, and reproduces the commands, bit
for bit.

  $ frobc trace $examples/wall_follow/wall_follow.frob --input one.csv --output replayed.csv
  $ head -1 replayed.csv
  time,out.forward,out.turn
  $ sed 's/,.*,\([^,]*,[^,]*\)$/,\1/' one.csv | cmp - replayed.csv
