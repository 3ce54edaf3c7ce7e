# What `make seeds` runs: COUNT seeds of each example on each robot that it fits,
# within the bounds that the examples' READMEs state.
count=$1
run=$(dirname "$0")
examples=$run/../../examples
status=0
follow="mean_wall_distance_error 0 0.03 largest_wall_distance_error 0 0.15 collisions 0 0"
for robot in pioneer scout create; do
  sh "$run/seeds.sh" "$examples/wall_follow" $robot "$count" $follow || status=1
done
for robot in pioneer scout create; do
  sh "$run/seeds.sh" "$examples/bug" $robot "$count" result true true collisions 0 0 \
    odometry_error_at_the_end 0 1 -- --for 6min --exit-when-done || status=1
done
exit $status
