The motions of the library on each robot, with noise: a path with sharp corners that crosses itself,
poses and turns; a drive around pillars; repeated attempts after a blocked way;
and wandering without a goal. (`make seeds` runs the same with many more seeds.)

  $ for robot in pioneer scout create; do
  >   for name in follow again wander; do frobc test motions/$name.frob --robot $robot --seeds 2 | grep -v '^   '; done
  > done
  ok    follows the path and takes the pose: 2 seeds, 80 s
  1 test: all hold
  ok    comes to the place: 2 seeds, 180 s
  1 test: all hold
  ok    drives on for five minutes, and stays nowhere: 2 seeds, 300 s
  1 test: all hold
  ok    follows the path and takes the pose: 2 seeds, 80 s
  1 test: all hold
  ok    comes to the place: 2 seeds, 180 s
  1 test: all hold
  ok    drives on for five minutes, and stays nowhere: 2 seeds, 300 s
  1 test: all hold
  ok    follows the path and takes the pose: 2 seeds, 80 s
  1 test: all hold
  ok    comes to the place: 2 seeds, 180 s
  1 test: all hold
  ok    drives on for five minutes, and stays nowhere: 2 seeds, 300 s
  1 test: all hold
  $ for robot in pioneer scout; do frobc test motions/around.frob --robot $robot | grep -v '^   '; done
  ok    drives around three pillars: 3 seeds, 60 s
  1 test: all hold
  ok    drives around three pillars: 3 seeds, 60 s
  1 test: all hold
  $ for robot in pioneer scout create; do frobc test motions/by_lidar.frob --robot $robot --seeds 2 | grep -v '^   '; done
  ok    drives around three pillars by lidar: 2 seeds, 60 s
  1 test: all hold
  ok    drives around three pillars by lidar: 2 seeds, 60 s
  1 test: all hold
  ok    drives around three pillars by lidar: 2 seeds, 60 s
  1 test: all hold

Each task of the first program ends with True, also in single precision:

  $ frobc run motions/follow.frob --robot pioneer --world motions/hall.toml --for 90s --exit-when-done --real float |
  >   grep -e result -e collisions
  collisions: 0
  result: (true, true, true)

A place behind a wall that closes off the hall cannot be reached; the tasks end with False in time:

  $ cat > closed.toml << TOML
  > [start]
  > x = 1
  > y = 1
  > 
  > [[wall]]
  > points = [[0, 0], [3, 0], [3, 5], [0, 5]]
  > closed = true
  > TOML
  $ cat > closed.frob << FROB
  > import Geometry
  > import Motion
  > import Robot
  > main :: (HasSonarRing i, DiffDrive o) => Program i o
  > main = reactimateTask (watching (do
  >     around <- driveAround goal
  >     again <- recover 2 (driveTo goal)
  >     path <- followPath pursuit [zeroVec, goal]
  >     pose <- goToPose Pose { position = goal, heading = 0 }
  >     return (around, again, path, pose)))
  > goal :: Point2
  > goal = Vec2 { x = 5[m], y = 0 }
  > FROB
  $ for robot in pioneer scout; do
  >   frobc run closed.frob --robot $robot --world closed.toml --for 300s --exit-when-done | grep -e result -e collisions
  > done
  collisions: 0
  result: (false, false, false, false)
  collisions: 0
  result: (false, false, false, false)
