A program that reads a bumper needs a topic, which the user names. Here with the
fake ROS 2, in which the bumper is pressed at a given time.

  $ . ./ros.sh
  $ cat >careful.frob <<END
  > import Robot
  > main :: (HasBumpers i, HasBattery i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (speed i) 0)) where
  >     speed i = if bumped i || batteryVoltage i < 11[V] then 0 else 0.2[m/s]
  > END
  $ bumpers="-r bumper_left:=bumps/left -r drive:bumper_right:=bumps/right -r bumper_back:=bumps/back"
  $ speeds="0 0.2 0"; faults=bump=0.6
  $ run_ros careful.frob --for 1s --record log.csv --ros-args $bumpers --; cat messages velocities
  0.000 0.000
  0.200 0.000
  0.000 0.000
  $ head -1 log.csv | tr , '\n' | grep -e battery -e bumper
  in.battery
  in.console.left bumper
  in.console.right bumper
  in.console.back bumper
  $ tail -1 log.csv | cut -d, -f7
  12.5

Without a topic, it does not start.

  $ frobc run --ros2 careful.frob --ros-args -r bumper_left:=bumps/left -r my_bumper_right:=right
  error: careful.frob:4: careful reads the right bumper of the robot (`bumpedRight`), but no topic is configured for it: add `--ros-args -r bumper_right:=TOPIC`, with a topic of the type std_msgs/msg/Bool
  [2]

In the simulator, the robot's contacts press the bumpers.

  $ cat >wall.toml <<END
  > robot = "ros"
  > [start]
  > x = 0.5
  > y = 1
  > [[wall]]
  > points = [[1, 0], [1, 2]]
  > END
  $ frobc run careful.frob --world wall.toml --for 5s --record log.csv | grep -e distance -e collisions
  distance driven: 0.279 m
  collisions: 1
  $ tail -1 log.csv | cut -d, -f7,9-
  14.4,true,true,false,0,0
