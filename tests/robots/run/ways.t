Distances and turns by odometry, on each robot: a square, a turn of more than a full circle, back
again, and a wall that ends a drive.

  $ cat > ways.frob << FROB
  > import Robot
  > main :: (HasSonar i, DiffDrive o) => Program i o
  > main = reactimateTask (watching (do
  >     repeatT 4 (do
  >         forward 0.5[m]
  >         turnBy (-90[deg]))
  >     turnBy 450[deg]
  >     back <- forward (-0.3[m])
  >     y <- ask (arr (\i -> (place i).y))
  >     wall <- forward 9[m]
  >     return (back, y < -0.25[m] && y > -0.35[m], wall)))
  > FROB
  $ cat > room.toml << TOML
  > [start]
  > x = 1.5
  > y = 1.5
  > 
  > [[wall]]
  > points = [[0, 0], [4, 0], [4, 3], [0, 3]]
  > closed = true
  > TOML
  $ for robot in pioneer scout create; do
  >   frobc run ways.frob --robot $robot --world room.toml --for 120s --exit-when-done | grep -v '^time\|^simulated\|^distance\|^finished\|^odometry'
  > done
  collisions: 0
  result: (true, true, false)
  collisions: 0
  result: (true, true, false)
  collisions: 0
  result: (true, true, false)
