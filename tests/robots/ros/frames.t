The positions in some messages are relative to a frame, which is often not the
robot's. The node reads the transforms of /tf_static and /tf. Here with the fake ROS 2.

A lidar looks back from its place, so it does not see the wall ahead. Its scans count as
soon as the transform arrives.

  $ . ./ros.sh
  $ cat >seen.frob <<END
  > import Lidar
  > import Robot
  > main :: (HasLidar i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (hold 0 (mapE speed (lidar i))) 0)) where
  >     speed :: Scan 4 -> Velocity
  >     speed scan = if sees 0 then 0.1[m/s] else if sees 180[deg] then 0.2[m/s] else 0.3[m/s] where
  >         sees bearing = case rangeAt bearing scan of
  >             Just far -> far < 2[m]
  >             Nothing -> False
  > END
  $ speeds="0 0.1 0"; faults=; run_ros seen.frob --for 1s; cat messages velocities
  0.000 0.000
  0.100 0.000
  0.000 0.000
  $ speeds="0 0.2 0"; faults="frame=0 frames=0.5"; run_ros seen.frob --for 1.5s; cat messages
  $ faults="frame=0 frames=0 upside_down=0"; run_ros seen.frob --for 1s; cat messages

A lidar may be at an unknown place, or tilted. Then the robot stands still.

  $ unplaced () { run_once seen.frob "$@"; cat messages; }
  $ faults="frame=0"; unplaced --for 5s; grep stale summary
  warning: a message on /scan is ignored: no transform between its frame `laser` and `base_link` is known, and the robot stands still: start the node that publishes it on /tf_static or /tf, or set the position of the lidar with `--set lidar_x=...`, `lidar_y` and `lidar_heading`
  stale readings: 1
  $ faults="frame=0 frames=0 tilt=0"; unplaced --for 1s
  warning: a message on /scan is ignored: its frame `laser` is tilted, so its rays are not parallel to the floor, and the robot stands still: correct the transform, or set the position of the lidar with `--set lidar_x=...`, `lidar_y` and `lidar_heading`
  $ faults="frame=0 frames=0 bad_frames=0"; unplaced --for 1s | grep transform.from
  warning: the transform from `map` to `odom` on /tf is ignored: a rotation is not a quaternion of length 1

The settings of the driver override the transforms.

  $ speeds="0 0.1 0"; faults="frame=0"; run_ros seen.frob --for 1s --set lidar_x=0.1; cat messages

Not every installation has the package tf2_msgs.

  $ mv prefix/lib/libtf2_msgs__rosidl_typesupport_c.so hidden
  $ faults="frame=0"; unplaced --for 1s
  warning: a message on /scan is ignored: it is in the frame `laser`, and /tf cannot be read, because the package tf2_msgs is not installed, and the robot stands still: install it, or set the position of the lidar with `--set lidar_x=...`, `lidar_y` and `lidar_heading`
  $ mv hidden prefix/lib/libtf2_msgs__rosidl_typesupport_c.so

The measurements of an inertial unit are in the directions of its frame: here it looks back.

  $ cat >felt.frob <<END
  > import Imu
  > import Robot
  > main :: (HasImu i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (hold 0 (mapE speed (imu i))) 0)) where
  >     speed reading
  >         | reading.acceleration.x < -0.4[m/s^2] = 0.1[m/s]
  >         | reading.acceleration.x > 0.4[m/s^2] = 0.2[m/s]
  >         | otherwise = 0.3[m/s]
  > END
  $ speeds="0 0.3 0"; faults=; run_ros felt.frob --for 1s; cat messages
  $ speeds="0 0.1 0"; faults="imu_frame=0 frames=0"; run_ros felt.frob --for 1s; cat messages
  $ speeds="0 0.2 0"; faults="imu_frame=0"; run_ros felt.frob --for 1s --set imu_aligned=1; cat messages
  $ unfelt () { run_once felt.frob "$@"; cat messages; }
  $ faults="imu_frame=0"; unfelt --for 5s; speeds_are 0
  warning: a message on /imu is ignored: no transform between its frame `laser` and `base_link` is known: start the node that publishes it on /tf_static or /tf, or add `--set imu_aligned=1` if the unit's axes match the robot's

A click in rviz is a click on the map of the program's console.

  $ cat >clicked.frob <<END
  > import Geometry
  > import Robot
  > main :: (HasConsole i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (speed (hold origin (mapClicked i))) 0)) where
  >     origin = Vec2 { x = 0, y = 0 }
  >     speed p = if p.x == 2[m] && p.y == 1[m] then 0.2[m/s] else 0
  > END
  $ speeds="0 0.2 0"; faults=click=0.3; run_ros clicked.frob --for 1s; cat messages
  $ faults="click=0.5 map=0 frames=0"; run_ros clicked.frob --for 1s; cat messages
  $ clicks () { run_once clicked.frob --for 2s; cat messages; }
  $ faults="click=0.3 map=0"; clicks
  warning: a message on /clicked_point is ignored: no transform between its frame `map` and `odom` is known: start the node that publishes it on /tf_static or /tf, or choose another fixed frame in rviz
  $ faults="click=0.3 nan_click=0"; clicks
  warning: a message on /clicked_point is ignored: its position is not a finite number
  $ faults="lossy=0"; clicks
  warning: the node base publishes /clicked_point with the reliability `best effort`, so no message gets through: set the reliability of its publisher to `reliable`
