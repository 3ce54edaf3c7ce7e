`frobc serve --robot ros` simulates a robot as a ROS 2 node: here with the fake
ROS 2, in which another node drives the robot ahead.

  $ . ./ros.sh
  $ serve () { FAKE_ROS=$faults virtually frobc serve --robot ros "$@" >served 2>messages; }
  $ driven () { sed -n 's/^distance driven: \(.*\) m/\1/p' served; }
  $ has_driven () { awk -v far="$(driven)" 'BEGIN { exit !(far > 0.1) }'; }

  $ faults=drive=0; serve --for 2s; cat messages
  $ has_driven && sed -n '1,5p' served
  node: /robot
  odometry: /odom
  lidar: /scan
  imu: /imu
  velocity: /cmd_vel

It publishes its place, and the frames of its sensors. Each sensor is at its position on the robot.

  $ cat >seats.toml <<END
  > [start]
  > x = 1
  > y = 1
  > [[lidar]]
  > ahead = 0.15
  > left = -0.05
  > [[lidar]]
  > name = "rear"
  > ahead = -0.2
  > END
  $ faults=; : >velocities; serve --world seats.toml --for 0.1s; grep '^/tf' velocities
  /tf_static: base_link to lidar_link, 0.15 -0.05
  /tf_static: base_link to rear_link, -0.2 0
  /tf_static: base_link to imu_link, 0 0
  /tf: odom to base_link, 0 0

Without the package tf2_msgs, which not every installation has, it says so.

  $ mv prefix/lib/libtf2_msgs__rosidl_typesupport_c.so hidden; : >velocities
  $ serve --for 0.1s; cat messages; grep '^/tf' velocities
  warning: the simulated robot does not publish /tf, because the package tf2_msgs is not installed
  [1]
  $ mv hidden prefix/lib/libtf2_msgs__rosidl_typesupport_c.so

The robot stops half a second after the last velocity, and at a velocity that is
not a number. The log has the velocities.

  $ faults="drive=0 silent=0.6"
  $ logged () { rm -f told; serve --log told "$@"; }
  $ logged --for 2s; cut -d' ' -f2- told
  VEL 0.3000 0.0000
  VEL 0.0000 0.0000
  $ faults="drive=0 nan=0.6"; logged --for 1s; cat messages
  warning: a velocity on /cmd_vel is not a number; the robot stops

Velocities of the other type are reported.

  $ faults="drive=0 stamps=0"; serve --for 3s; cat messages
  warning: the node base publishes geometry_msgs/msg/TwistStamped on /cmd_vel, but the simulated robot needs geometry_msgs/msg/Twist: add --stamped

The node crashes:

  $ faults=crash=0.3; serve --for 5s; tail -1 messages
  error: the ROS 2 node has ended

A world may have several lidars, and none of them need be called `lidar`.

  $ cat >two.toml <<END
  > [start]
  > x = 1
  > y = 1
  > [[lidar]]
  > name = "front"
  > [[lidar]]
  > name = "rear"
  > END
  $ faults=; serve --world two.toml --for 0.1s; sed -n '3,5p' served
  lidar: /front
  lidar: /rear
  imu: /imu

Topics are remapped.

  $ serve --for 0.1s --ros-args -r odom:=base/odom -r __node:=sim --; sed -n '1,2p' served
  node: /sim
  odometry: /base/odom
  $ serve --ros-args -r odom; cat messages
  error: invalid argument after --ros-args: Couldn't parse remap rule

Mistakes on the command line:

  $ frobc serve --robot ros --tcp 0
  error: a robot in ROS 2 has no serial line: remove --tcp, --link and --rate
  [2]
  $ frobc serve --robot ros --link robot
  error: a robot in ROS 2 has no serial line: remove --tcp, --link and --rate
  [2]
  $ frobc serve --robot scout --stamped
  error: --stamped is for the robot `ros`: add --robot ros
  [2]
  $ frobc serve --ros-args -r odom:=odometry
  error: --ros-args is for the robot `ros`: add --robot ros
  [2]
  $ AMENT_PREFIX_PATH= frobc serve --robot ros 2>&1 | sed 's/`source .*`/`source …`/'
  error: there is no ROS 2 in this shell: install it, and source its setup script, as in `source …`, which sets AMENT_PREFIX_PATH
