The summary reports a collision with a wall, and with --strict it is a fault. If
there is no world next to the program, the default is the room that comes with
frobc.

  $ cat > ahead.frob <<EOF
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (constant (roMake (setVelTR 0.3[m/s] 0)))
  > EOF
  $ frobc run ahead.frob --for 30s | grep collisions
  collisions: 1
  $ frobc run ahead.frob --for 30s --strict > summary
  error: the robot collided with something
  [4]
  $ frobc run ahead.frob --for 5s --strict | grep collisions
  collisions: 0

A command that is not a number stops the robot.

  $ cat > dead_sensor.frob <<EOF
  > import Robot
  > nan = 0 / 0
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (proc _ -> roMake (setVelTR (if time () < 3[s] then 0.3[m/s] else nan * 1[m/s]) 0))
  > EOF
  $ frobc run dead_sensor.frob --for 20s --strict --record log.csv | grep collisions
  collisions: 0
  $ tail -1 log.csv | cut -d, -f5,6,30,31
  0,0,nan,0

A world file that cannot be read or used is a usage error, and every mistake in it is reported with
its place.

  $ frobc run ahead.frob --world missing.toml
  error: there is no world `missing.toml` here or next to ahead.frob or among the worlds that come with frobc: room.toml
  [2]
  $ cat > world.toml <<EOF
  > [start]
  > x = 1
  > y = 1
  > heading = 90
  > [[wall]]
  > points = [[0, 0]]
  > EOF
  $ frobc run ahead.frob
  error: ./world.toml:4:1: unknown key `heading`; did you mean `heading_deg`?
  error: ./world.toml:6:10: `points` takes a list of at least 2 points [x, y]
  [2]
