BUG reaches a goal behind a convex obstacle, a concave one and a long wall, touching nothing, on
each robot. `make seeds` does the same with a hundred seeds.

  $ for robot in pioneer scout create; do
  >   sh seeds.sh ../../../examples/bug $robot 3 result true true collisions 0 0 odometry_error_at_the_end 0 1 finished_after 100 240 -- --for 6min --exit-when-done
  > done
  pioneer: 0 of 3 seeds out of bounds
  scout: 0 of 3 seeds out of bounds
  create: 0 of 3 seeds out of bounds

By odometry it ends at the goal, 13 m from its start, and has passed each of the obstacles: behind
the convex one, inside the concave one, round the long wall.

  $ frobc run ../../../examples/bug/bug.frob --for 6min --exit-when-done --record run.csv > summary
  $ awk -F, 'NR > 1 { x = $2; y = $3; convex += x < 3 && y > 0.8; inside += x > 6 && x < 7 && y * y < 0.04; above += x > 10.4 && y > 1.4; below += x > 10.4 && y < -1.9 }
  >   END { print ((x - 13) ^ 2 + y ^ 2 < 0.15 ^ 2), (convex > 0), (inside > 0), (above > 0), (below > 0) }' run.csv
  1 1 1 1 1

The interpreter has the same outputs, bit for bit.

  $ frobc trace ../../../examples/bug/bug.frob --input run.csv > compiled.csv
  $ frobc trace ../../../examples/bug/bug.frob --input run.csv --engine interp | cmp - compiled.csv

A goal inside walls cannot be reached: the robot drives round the wall twice, and reports that.

  $ for robot in pioneer scout create; do
  >   sh seeds.sh ../../../examples/bug $robot 2 result false false collisions 0 0 finished_after 60 120 -- --for 6min --exit-when-done --world ../../../examples/bug/enclosed.toml
  > done
  pioneer: 0 of 2 seeds out of bounds
  scout: 0 of 2 seeds out of bounds
  create: 0 of 2 seeds out of bounds
