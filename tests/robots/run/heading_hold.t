The robot turns to its course, 25 degrees to the right, holds it, and comes to
rest half a metre before the wall at the end (its front transducers are 0.166 m ahead of
its axle, which is at 7.28 m then, 6.68 m from the start).

  $ . ./within.sh
  $ frobc run ../../../examples/heading_hold/heading_hold.frob --for 25s --record hold.csv > summary
  $ within distance_driven 6.5 6.9 collisions 0 0 < summary
  $ tail -1 hold.csv | awk -F, '{ error = $4 + 25 * 3.14159265 / 180; print (error < 0.02 && error > -0.02), ($30 < 0.02 && $30 > -0.02) }'
  1 1

The trial also succeeds at other rates.

  $ for rate in 20 100; do frobc test ../../../examples/heading_hold/heading_hold.frob --rate $rate | grep -c '^ok'; done
  7
  7
