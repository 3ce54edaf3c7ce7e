Programs run as ROS 2 nodes: here with a fake ROS 2, whose robot publishes
odometry and drives as the node's velocities say (fake/fake_ros.c).

  $ . ./ros.sh

The program drives 0.3 m. The recording has the odometry and the commands.
The first velocity is zero.

  $ run_node 2s ""; grep -v -e '^time' -e '^steps' -e '^over' -e '^longest' -e '^late' summary; cat messages
  robot: node /drive, odometry from /odom, velocity to /cmd_vel
  stale readings: 0
  connections: 1
  log: log.csv
  $ cat velocities
  0.000 0.000
  0.200 0.000
  0.000 0.000
  $ head -1 log.csv; tail -1 log.csv | awk -F, '{ print ($2 >= 0.3 && $2 < 0.4), $8 }'
  time,in.odometry.position.x,in.odometry.position.y,in.odometry.heading,in.speed,in.turning,in.key,out.forward,out.turn
  1 0

Arguments for ROS 2 follow --ros-args, up to a `--`.

  $ run_node 0.1s "" --ros-args -r odom:=base/odom -r __node:=follower
  $ head -1 summary
  robot: node /follower, odometry from /base/odom, velocity to /cmd_vel
  $ steady frobc run --ros2 drive.frob --ros-args -r odom:=base/odom -r cmd_vel:=base/cmd_vel -- --for 0.1s | head -1
  robot: node /drive, odometry from /base/odom, velocity to /base/cmd_vel
  $ frobc run --ros2 drive.frob --for 1s --ros-args -r odom
  error: wrong argument after --ros-args: Couldn't parse remap rule
  [2]

A parameter of the program:

  $ cat >paced.frob <<END
  > import Robot
  > param pace :: Velocity = 0.2[m/s]
  > main :: DiffDrive o => Program i o
  > main = reactimateRobot (proc _ -> roMake (setVelTR pace 0))
  > END
  $ rm velocities
  $ steady frobc run --ros2 paced.frob $patient --for 0.3s --ros-args -p pace:=0.1 -p use_sim_time:=true -p other:=1 >summary
  warning: use_sim_time is not supported: the steps of paced follow the clock of this machine, not /clock
  warning: paced has no parameter `other`; --help lists its parameters
  $ cat velocities
  0.000 0.000
  0.100 0.000
  0.000 0.000
  $ frobc run --ros2 paced.frob --for 0.3s --ros-args -p pace:=fast
  error: the parameter `pace` is a number of m/s, not `fast`
  [2]

Messages of type TwistStamped:

  $ run_node 0.3s "" --set stamped=1; cat messages velocities
  0.000 0.000 stamped
  0.200 0.000 stamped
  0.000 0.000 stamped

Speeds are limited:

  $ run_node 0.3s "" --set fastest=0.15; cat messages velocities
  0.000 0.000
  0.150 0.000
  0.000 0.000

No odometry, or odometry that is not usable, stops the robot. It continues
when messages are good again.

  $ patient="--patience 500ms"
  $ run_node 1.8s silent=0.5; cat messages velocities
  warning: no message on /odom for 1 s; the robot stands until one arrives
  0.000 0.000
  0.200 0.000
  0.000 0.000
  $ run_node 1.2s nan=0.5; cat messages velocities
  warning: a message on /odom does not count: its position is not a number
  0.000 0.000
  0.200 0.000
  0.000 0.000
  $ run_node 2s back=0.5; sed "s/by [0-9.]* s/by N s/" messages; cat velocities
  warning: the stamp of a message on /odom jumped back by N s; messages do not count until stamps have been regular for a second
  warning: the clock of the messages on /odom was set; they count again
  0.000 0.000
  0.200 0.000
  0.000 0.000
  0.200 0.000
  0.000 0.000
  $ run_node 2.2s old=1.2; grep late messages | sed "s/[0-9.]* s late/N s late/"; cat velocities
  warning: a message on /odom arrived N s late; late messages do not count
  0.000 0.000
  0.200 0.000
  0.000 0.000

  $ patient="--patience 1s --set late=1"

A program reads the lidar and the inertial measurement unit, and drives to half
a metre before the wall: 0.3 m, as distances count from the robot's front.

  $ steady env FAKE_ROS= timeout 60 frobc run --ros2 approach.frob $patient --for 3s --record log.csv >summary
  $ tail -1 log.csv | cut -d, -f2 | awk '{ print ($1 > 0.25 && $1 < 0.31) }'
  1
  $ head -1 log.csv | cut -d, -f8-
  in.console.imu,in.console.lidar 36,in.console.lidar 4,out.forward,out.turn
  $ grep -c 'Scan {ranges = .*Nothing' log.csv | awk '{ print ($1 > 10) }'
  1
  $ grep -c 'Imu {rate = Vec3 {x = 0, y = 0, z = 0.25}' log.csv | awk '{ print ($1 > 10) }'
  1
  $ steady env FAKE_ROS=no_angle=0.3 timeout 60 frobc run --ros2 approach.frob $patient --for 1s >summary
  warning: a message on /scan does not count: its angles are not numbers, or angle_increment is 0

Without a robot, the program waits; it names the topic.

  $ FAKE_ROS="silent=0 alone=0" timeout -s INT 3 frobc run --ros2 drive.frob >summary
  warning: no node publishes /odom (nav_msgs/msg/Odometry), which the program needs. Start the robot's nodes, or remap the topic with `--ros-args -r odom:=NAME`
  interrupted at 0.000 s: the summary covers the run until then; run the same command to start again
  error: the run was ended by an interrupt; sent a stop command to the robot
  [124]
  $ grep '^steps' summary
  steps: 0

Conflicts with other nodes are reported:

  $ run_node 1.5s "other_type=0 wants_stamped=0 same_name=0"; cat messages
  warning: /odom has two types, so no message gets through: the node base publishes geometry_msgs/msg/PoseStamped, and this program needs nav_msgs/msg/Odometry
  warning: /cmd_vel has two types, so no message gets through: the node base subscribes to geometry_msgs/msg/TwistStamped, and this program needs geometry_msgs/msg/Twist; add `--set stamped=1`
  warning: there is another node of the name /drive; rename this one with `--ros-args -r __node:=NAME`

The process of the node crashes. Another one is started, and stops the robot
before the program continues.

  $ run_node 4s crash=0.5; cat messages; head -4 velocities
  0.000 0.000
  0.200 0.000
  0.000 0.000
  0.200 0.000

The robot is stopped when any part of a run ends or is suspended.

  $ frobc build --ros2 drive.frob
  $ FAKE_ROS=crash=0.5 ./drive --reconnect 0 >summary
  error: lost the connection to the robot: the process of the ROS 2 node has ended; the robot could not be reached to stop it
  [4]
  $ start_node ""; kill -INT $run; wait $run; until_stopped
  last velocity: 0.000 0.000
  $ start_node ""; kill -KILL $controller; wait $run; until_stopped
  last velocity: 0.000 0.000
  $ tail -1 messages
  error: the controller was killed by signal 9 (Killed); sent a stop command to the robot
  $ start_node ""; kill -KILL $run; until_stopped
  last velocity: 0.000 0.000
  $ start_node ""; kill -KILL -$run; until_stopped
  last velocity: 0.000 0.000
  $ start_node ""; kill -STOP $run; until_stopped
  last velocity: 0.000 0.000
  $ kill -KILL $run

None of these processes survives.

  $ until_true '! pgrep -f "^[^ ]*drive --ros-node" >/dev/null'

Mistakes on the command line:

  $ AMENT_PREFIX_PATH= frobc run --ros2 drive.frob 2>&1 | sed 's/`source .*`/`source …`/'
  error: there is no ROS 2 in this shell: install it, and source its setup script, as in `source …`, which sets AMENT_PREFIX_PATH
  $ rm prefix/share/ament_index/resource_index/packages/*_msgs
  $ ROS_DISTRO=jazzy frobc run --ros2 drive.frob
  error: ROS 2 in this shell (AMENT_PREFIX_PATH) lacks the packages geometry_msgs, nav_msgs and sensor_msgs: install them, as in `sudo apt install ros-jazzy-geometry-msgs ros-jazzy-nav-msgs ros-jazzy-sensor-msgs`
  [2]
  $ rm prefix/share/ament_index/resource_index/packages/rcl
  $ sh fake/build.sh fake "$PWD/prefix"
  $ sed -i 's/9.2.8/5.3.1/' prefix/share/rcl/package.xml
  $ run_node 0.1s ""; cat messages
  warning: frobc is tested with ROS 2 Jazzy and Kilted, not with the one in this shell, whose rcl has version 5.3.1
  $ frobc run --ros2 --robot scout drive.frob
  error: --ros2 is for the robot `ros`, not for `scout`: remove --robot
  [2]
  $ frobc run --ros2 --device /dev/ttyUSB0 drive.frob
  error: the robot is either on a serial line or in ROS 2: remove --device or --ros2
  [2]
  $ frobc run drive.frob --ros-args -r odom:=odometry
  error: --ros-args only works with --ros2: add it
  [2]
  $ frobc run --ros2 drive.frob --strict
  error: --strict only works in the simulator: remove it, or remove --ros2
  [2]
  $ frobc build --ros2 --target linux drive.frob
  error: --ros2 builds an executable for this machine: remove --shared and --target
  [2]
  $ frobc run --robot ros --device /dev/ttyUSB0 drive.frob
  error: drive is compiled for `ros`, a robot that has no serial line: use `frobc run --ros2` or `frobc build --ros2`
  [2]
  $ frobc build --robot ros drive.frob
  error: drive is compiled for `ros`, a robot that has no serial line: use `frobc run --ros2` or `frobc build --ros2`
  [2]
  $ frobc export --robot ros --platformio out drive.frob
  error: drive is compiled for `ros`, a robot that has no serial line: use `frobc run --ros2` or `frobc build --ros2`
  [2]
  $ cat >pioneer.frob <<END
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (constant restingOutput)
  > END
  $ frobc run --ros2 pioneer.frob
  warning: frobc is tested with ROS 2 Jazzy and Kilted, not with the one in this shell, whose rcl has version 5.3.1
  error[E0503]: `main` is a program for `pioneer`, not for `ros`
   --> pioneer.frob:3:1
    |
  3 | main = reactimateRobot (constant restingOutput)
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: allow any robot, as in `main :: (HasSonar i, DiffDrive o) => Program i o`
  
  1 error
  [1]

  $ ./drive --help | head -12
  usage: drive [OPTION]... [--ros-args ARG...]
  
  Runs the program drive.
  
    --ros-args ARG... [--]
                       arguments for ROS 2, up to `--`, such as `-r odom:=NAME` to remap
                       a topic, or `-r __node:=NAME` to rename the node
    --for SECONDS      how long to run (until interrupted)
    --rate HZ          how often the controller runs (50)
    --record FILE.csv  record the inputs and outputs of the program (FILE.csv.gz: compressed)
    --patience SECONDS maximum age of a reading, and maximum duration of a step,
                       before the robot is stopped (0.2)
