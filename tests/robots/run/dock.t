The robot drives into the dock, to a fifth of a metre in front of the wall at
its end. It is then in the alcove, within 8 cm of its middle line (by odometry).

  $ for robot in pioneer scout create; do
  >   sh seeds.sh ../../../examples/dock $robot 3 collisions 0 0 finished_after 20 40 -- --for 2min --exit-when-done
  >   frobc run ../../../examples/dock/dock.frob --robot $robot --for 2min --exit-when-done --record run.csv | sed -n 's/^result: \(Just 0\.[12]\).*/\1/p'
  >   awk -F, 'NR > 1 { x = $2; y = $3; h = $4 } END { print (x > 4.4 && x < 4.7), (y > 1.42 && y < 1.58), (h > -0.1 && h < 0.1) }' run.csv
  > done
  pioneer: 0 of 3 seeds out of bounds
  Just 0.1
  1 1 1
  scout: 0 of 3 seeds out of bounds
  Just 0.1
  1 1 1
  create: 0 of 3 seeds out of bounds
  Just 0.1
  1 1 1

If the alcove is blocked, it tries three times, backs out each time, and gives up.

  $ sed 's/\[5, 2.12\], \[6, 2.12\], \[6, 2.88\], \[5, 2.88\], //' ../../../examples/dock/world.toml > walled.toml
  $ frobc run ../../../examples/dock/dock.frob --world walled.toml --for 10min --exit-when-done --record run.csv | grep "result\|collisions"
  collisions: 0
  result: Nothing
  $ awk -F, 'NR > 1 { if ($2 > 3.4 && !in_) { in_ = 1; n++ } if ($2 < 3.1) in_ = 0 } END { print n, "attempts" }' run.csv
  3 attempts
