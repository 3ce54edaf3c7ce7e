The robot drives back and forth between two places, past a pillar in its way.
Within three minutes it is at each end at least twice (by odometry), and it
touches nothing.

  $ for robot in pioneer scout create; do
  >   sh seeds.sh ../../../examples/patrol $robot 2 collisions 0 0 distance_driven 30 45 -- --for 3min
  >   frobc run ../../../examples/patrol/patrol.frob --robot $robot --for 3min --record run.csv > summary
  >   awk -F, 'NR > 1 { far = ($2 - 6) ^ 2 + $3 ^ 2 < 0.04; home = $2 ^ 2 + $3 ^ 2 < 0.04
  >                     if (far && at != "far") { at = "far"; fars++ } if (home && at != "home") { at = "home"; homes++ } }
  >     END { print (fars >= 2), (homes >= 2) }' run.csv
  > done
  pioneer: 0 of 2 seeds out of bounds
  1 1
  scout: 0 of 2 seeds out of bounds
  1 1
  create: 0 of 2 seeds out of bounds
  1 1
