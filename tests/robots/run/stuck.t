A driving task ends if the robot cannot move, and reports that: there is a wall behind the robot,
which no sonar used by `forward` sees, and it is in a corridor that is narrower than its diagonal.

  $ cat > stuck.frob <<EOF
  > import Geometry
  > import Robot
  > 
  > back :: (HasSonar i, DiffDrive o) => Program i o
  > back = reactimateTask (watching (do
  >     done <- forward (-2[m])
  >     turned <- turnBy 90[deg]
  >     return (done, turned)))
  > 
  > turns :: (HasSonar i, DiffDrive o) => Program i o
  > turns = reactimateTask (watching (do
  >     turned <- turnBy 90[deg]
  >     further <- turnBy (-450[deg])
  >     arrived <- driveTo (Vec2 { x = -2[m], y = 0 })
  >     ahead <- forward 0.5[m]
  >     return (turned, further, arrived, ahead)))
  > EOF
  $ cat > behind.toml <<EOF
  > [start]
  > x = 0
  > y = 0
  > 
  > [[wall]]
  > points = [[-0.8, -2], [-0.8, 2]]
  > EOF
  $ cat > corridor.toml <<EOF
  > [start]
  > x = 0
  > y = 0
  > 
  > [[wall]]
  > points = [[-3, 0.32], [3, 0.32]]
  > 
  > [[wall]]
  > points = [[-3, -0.32], [3, -0.32]]
  > EOF
  $ run () { frobc run stuck.frob "$@" --for 120s --exit-when-done > summary || cat summary
  >   grep result summary; awk '/finished after/ { print ($3 < 20 ? "in time" : "after " $3 " s") }' summary; }
  $ for robot in pioneer scout create; do run --entry back --robot $robot --world behind.toml; done
  result: (false, true)
  in time
  result: (false, true)
  in time
  result: (false, true)
  in time
  $ own=../../../examples/own_robot
  $ run --entry back --robot $own/Rover.frob --with $own/rover_body.c --world behind.toml
  result: (false, true)
  in time
  $ run --entry turns --robot pioneer --world corridor.toml
  result: (false, false, false, false)
  in time

A straining motor counts, also on a floor where the wheels slip.

  $ printf '[drive]\nslip = 0.1\n' >> behind.toml
  $ for robot in pioneer scout create; do run --entry back --robot $robot --world behind.toml; done
  result: (false, true)
  in time
  result: (false, true)
  in time
  result: (false, true)
  in time
