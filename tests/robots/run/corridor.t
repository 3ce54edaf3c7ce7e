The robot drives down the middle of a corridor with a bend, to its end, on each
robot.

  $ for robot in pioneer scout create; do
  >   sh seeds.sh ../../../examples/corridor $robot 3 collisions 0 0 largest_wall_distance_error 0 0.15 finished_after 28 35 result 8.8 9.2 -- --exit-when-done
  > done
  pioneer: 0 of 3 seeds out of bounds
  scout: 0 of 3 seeds out of bounds
  create: 0 of 3 seeds out of bounds
