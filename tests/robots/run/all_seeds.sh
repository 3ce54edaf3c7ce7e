# The script of `make seeds`: runs COUNT seeds of each example on each robot, with the bounds that
# the examples' READMEs state.
count=$1
run=$(dirname "$0")
status=0
robots="pioneer scout create"
each () {
  echo "$1:"
  for robot in $robots; do
    example=$1
    shift
    sh "$run/seeds.sh" "$run/../../../examples/$example" $robot "$count" "$@" || status=1
    set -- "$example" "$@"
  done
}
each wall_follow mean_wall_distance_error 0 0.03 largest_wall_distance_error 0 0.15 collisions 0 0
each bug result true true collisions 0 0 odometry_error_at_the_end 0 1 -- --for 6min --exit-when-done
each corridor collisions 0 0 largest_wall_distance_error 0 0.15 result 8.8 9.2 -- --exit-when-done
each patrol collisions 0 0 distance_driven 30 45 squares 8 20 -- --for 3min
each dock collisions 0 0 odometry_error_at_the_end 0 0.2 finished_after 20 40 -- --for 2min --exit-when-done
each explore longest_stay 0 60 squares 15 70 -- --for 5min
each subsumption collisions 0 0 distance_driven 20 60 -- --for 3min
each vfh collisions 0 0 distance_driven 17 22 finished_after 45 80 -- --for 90s --exit-when-done
each follow_ball collisions 0 0 mean_ball_distance_error 0 0.03 largest_ball_distance_error 0 0.05 -- --for 60s
robots=create # with sensors that look down
each line_follow collisions 0 0 mean_distance_from_the_tape 0 0.01 largest_distance_from_the_tape 0 0.04 distance_along_the_tape 45 50 -- --for 220s
echo "motions:"
for name in follow again wander by_lidar around; do
  for robot in pioneer scout create; do
    test "$name $robot" = "around create" || # it has no ring of sonars
      frobc test "$run/motions/$name.frob" --robot $robot --seeds "$count" || status=1
  done
done
echo "light_seek:"
seek=$run/../../../examples/light_seek
sh "$run/seeds.sh" "$seek" "$seek/Moth.frob" "$count" collisions 0 0 distance_driven 5 8 finished_after 30 50 \
  -- --with "$seek/moth_body.c" --for 2min --exit-when-done || status=1
exit $status
