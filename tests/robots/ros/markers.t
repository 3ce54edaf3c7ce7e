A node publishes what the program draws as markers, in the frames of the odometry and of
the robot. Here with the fake ROS 2, which logs the first markers, and those that are removed.

  $ . ./ros.sh
  $ cat >draws.frob <<END
  > import Display
  > import Geometry
  > import Robot
  > main :: (HasOdometry i, DiffDrive o, HasDisplay o) => Program i o
  > main = reactimateRobot (proc i -> marks i (roMake (setVelTR 0.2[m/s] 0))) where
  >     marks i = goalMarks . robotMarks . draw (InWorld Yellow (Cross (place i))) . draw (number "x" (place i).x)
  >     goalMarks = draw (InWorld Red (Circle goal 0.5[m])) . draw (InWorld Blue (label goal "the \\"goal\\"\\\\"))
  >     robotMarks = draw (OnRobot Grey (Box ahead 90[deg] 0.4[m] 0.2[m])) . nowhere . draw (OnRobot Green (Arrow zero ahead))
  >     nowhere = draw (InWorld Red (Line zero (Vec2 { x = 0[m] / 0, y = 0 })))
  >     goal = Vec2 { x = 2[m], y = 1[m] }
  >     zero = Vec2 { x = 0, y = 0 }
  >     ahead = Vec2 { x = 0.5[m], y = 0 }
  > END
  $ speeds="0 0.2 0"; faults=; run_ros draws.frob --for 1s --record log.csv; cat messages
  $ grep marker velocities
  marker 0: in odom, type 5, 4 points, -0.05 -0.05 to 0.05 0.05
  marker 1: in base_link, type 0, 2 points, 0 0 to 0.5 0
  marker 2: in base_link, type 4, 5 points, 0.6 -0.2 to 0.6 0.2
  marker 3: in odom, `the "goal"\` at 2 1
  marker 4: in odom, type 4, 37 points, 2.5 1 to 2.4924 1.08682
  marker 0: removed
  marker 1: removed
  marker 2: removed
  marker 3: removed
  marker 4: removed

The outputs of the program are the same as without the drawing, and the drawing is not recorded.

  $ cut -d, -f1,9- log.csv >outputs; head -1 outputs
  time,out.forward,out.turn
  $ frobc trace draws.frob --robot ros --input log.csv | cmp - outputs

A setting turns the markers off. The executable of `frobc build` has no drawing without --markers.

  $ run_ros draws.frob --for 0.5s --set markers=0; grep marker velocities
  [1]
  $ frobc build --ros2 draws.frob && : >velocities && ./draws --for 0.5 >summary && grep marker velocities
  [1]
  $ frobc build --ros2 draws.frob --markers && ./draws --for 0.5 >summary && grep -c marker velocities
  10
  $ frobc build draws.frob --markers
  error: --markers only works with --ros2: add --ros2, or remove --markers
  [2]
  $ frobc export draws.frob --platformio out --markers
  error: --markers only works with --ros2: add --ros2, or remove --markers
  [2]
