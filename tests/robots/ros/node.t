Programs run as ROS 2 nodes: here with a fake ROS 2, whose robot publishes
odometry and drives as the node's velocities say (fake/fake_ros.c).

  $ . ./ros.sh
  $ speeds="0 0.2 0"

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
  $ head -1 log.csv; tail -1 log.csv | awk -F, '{ print ($2 >= 0.3 && $2 < 0.4), $9 }'
  time,in.odometry.position.x,in.odometry.position.y,in.odometry.heading,in.speed,in.turning,in.battery,in.key,out.forward,out.turn
  1 0

Arguments for ROS 2 follow --ros-args, up to a `--`.

  $ run_node 0.1s "" --ros-args -r odom:=base/odom -r __node:=follower
  $ head -1 summary
  robot: node /follower, odometry from /base/odom, velocity to /cmd_vel
  $ run_ros drive.frob --ros-args -r odom:=base/odom -r cmd_vel:=base/cmd_vel -- --for 0.1s; head -1 summary
  robot: node /drive, odometry from /base/odom, velocity to /base/cmd_vel
  $ frobc run --ros2 drive.frob --for 1s --ros-args -r odom
  error: invalid argument after --ros-args: Couldn't parse remap rule
  [2]

A parameter of the program:

  $ cat >paced.frob <<END
  > import Robot
  > param pace :: Velocity = 0.2[m/s]
  > main :: DiffDrive o => Program i o
  > main = reactimateRobot (proc _ -> roMake (setVelTR pace 0))
  > END
  $ speeds="0 0.1 0"
  $ run_ros paced.frob --for 0.3s --ros-args -p pace:=0.1 -p other:=1 --; cat messages
  warning: paced has no parameter `other`; --help lists its parameters
  $ cat velocities
  0.000 0.000
  0.100 0.000
  0.000 0.000
  $ frobc run --ros2 paced.frob --for 0.3s --ros-args -p pace:=fast
  error: the parameter `pace` is a number in m/s, not `fast`
  [2]

Other nodes cannot change it during the run. Knobs and toggles of the console
are parameters too, which they can change.

  $ FAKE_ROS_SET=pace=0.3 faults=set=0.2; export FAKE_ROS_SET
  $ run_ros paced.frob --for 0.6s --ros-args -p pace:=0.1 --; cat messages velocities
  0.000 0.000
  0.100 0.000
  set_parameters: `pace` is fixed during a run: restart the node with `--ros-args -p pace:=VALUE`, or make it a knob on the program's console
  0.000 0.000
  $ cat >tuned.frob <<END
  > import Robot
  > main :: (HasConsole i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (knob "pace" 0 0.5[m/s] 0.1[m/s] i) 0))
  > END
  $ speeds="0 0.1 0.3 0"
  $ run_ros tuned.frob --for 0.8s --record log.csv; cat messages velocities
  0.000 0.000
  0.100 0.000
  set_parameters: successful
  0.300 0.000
  0.000 0.000
  $ frobc trace tuned.frob --robot ros --input log.csv | tail -1 | cut -d, -f2
  0.29999999999999999
  $ speeds="0 0.2 0"; FAKE_ROS_SET=pace=0.6
  $ run_ros tuned.frob --for 0.6s --ros-args -p pace:=0.2 --; cat messages velocities
  0.000 0.000
  0.200 0.000
  set_parameters: `pace` must be a number from 0 to 0.5 m/s, not 0.6
  0.000 0.000
  $ speeds="0 0.4 0"
  $ for node in /tuned '/**' '/*' tuned '**/tuned'; do
  >   echo "$node pace 0.4" >values.yaml
  >   run_ros tuned.frob --for 0.1s --ros-args --params-file values.yaml --; speeds_are "$speeds" && echo ok
  > done
  ok
  ok
  ok
  ok
  ok
  $ echo "/robot1/tuned pace 0.4" >values.yaml; run_ros tuned.frob --for 0.1s --ros-args --params-file values.yaml -r __ns:=/robot1 --; speeds_are "$speeds" && echo ok
  ok
  $ speeds="0 0.1 0"; run_ros tuned.frob --for 0.1s --ros-args --params-file values.yaml --; speeds_are "$speeds" && echo ok
  ok
  $ frobc run --ros2 tuned.frob --for 0.3s --ros-args -p pace:=2
  error: `pace` must be a number from 0 to 0.5 m/s, not 2
  [2]
  $ faults=

The instants follow the time of a simulator on /clock, which here has half the
speed of real time. If the simulator is restarted, the program's time continues.

  $ speeds="0 0.1 0"
  $ run_ros paced.frob --for 0.5s --record log.csv --ros-args -p pace:=0.1 -p use_sim_time:=true --; cat messages velocities
  0.000 0.000
  0.100 0.000
  0.000 0.000
  $ tail -1 log.csv | awk -F, '{ print ($1 > 0.45 && $1 < 0.6), ($2 > 0.08) }'
  1 1
  $ faults=clock_back=0.6
  $ run_ros paced.frob --for 0.5s --record log.csv --ros-args -p pace:=0.1 -p use_sim_time:=true --; grep clock messages | sed 's/by [0-9.]* s/by N s/'
  warning: the time of /clock jumped back by N s; the program continues at its own time
  $ awk -F, '$1 + 0 < before { print "back" } { before = $1 + 0 }' log.csv
  $ faults=
  $ frobc run --ros2 paced.frob --for 0.3s --ros-args -p use_sim_time:=maybe
  error: the parameter `use_sim_time` must be true or false, not `maybe`
  [2]

The verdicts on assertions are published as diagnostics.

  $ cat >claims.frob <<END
  > import Robot
  > main :: (HasOdometry i, DiffDrive o) => Program i o
  > main = reactimateRobot drive
  > drive :: (HasOdometry i, DiffDrive o) => SF i o
  > drive = proc i -> roMake (setVelTR 0.2[m/s] 0) where
  >     assert "stays near" ((place i).x < 0.1[m])
  >     assert "stays on the floor" True
  > END
  $ speeds="0 0.2 0"
  $ run_ros claims.frob --for 0.9s; cat messages; sort -u velocities
  0.000 0.000
  0.200 0.000
  diagnostics: 0, claims: stays near: held
  diagnostics: 0, claims: stays on the floor: held
  diagnostics: 2, claims: stays near: violated

Messages of type TwistStamped:

  $ speeds="0 0.2 0"
  $ run_node 0.3s "" --set stamped=1; cat messages velocities
  0.000 0.000 stamped
  0.200 0.000 stamped
  0.000 0.000 stamped

Speeds are limited:

  $ speeds="0 0.15 0"
  $ run_node 0.3s "" --set fastest=0.15; cat messages velocities
  0.000 0.000
  0.150 0.000
  0.000 0.000

No odometry, or odometry that is not usable, stops the robot. It continues
when messages are good again.

  $ speeds="0 0.2 0" patient="--patience 500ms"
  $ run_node 1.8s silent=0.5; cat messages velocities
  warning: no message on /odom for 1 s; the robot stands still until one arrives
  0.000 0.000
  0.200 0.000
  0.000 0.000
  $ run_node 1.2s nan=0.5; cat messages velocities
  warning: a message on /odom is ignored: its position is not a finite number
  0.000 0.000
  0.200 0.000
  0.000 0.000
  $ speeds="0 0.2 0 0.2 0"
  $ run_node 2s back=0.5; sed "s/by [0-9.]* s/by N s/" messages; cat velocities
  warning: the timestamp of a message on /odom jumped back by N s; messages are ignored until timestamps have been regular for a second
  warning: the clock of the messages on /odom was set; they are accepted again
  0.000 0.000
  0.200 0.000
  0.000 0.000
  0.200 0.000
  0.000 0.000
  $ speeds="0 0.2 0"
  $ run_node 2.2s old=1.2; grep late messages | sed "s/[0-9.]* s late/N s late/"; cat velocities
  warning: a message on /odom arrived N s late; late messages are ignored
  0.000 0.000
  0.200 0.000
  0.000 0.000

  $ patient="--patience 1s --set late=1"

A program reads the lidar and the inertial measurement unit, and drives to half
a metre before the wall: 0.3 m, as distances count from the robot's front.

  $ faults= ; run_once approach.frob $patient --for 3s --record log.csv; cat messages
  $ tail -1 log.csv | cut -d, -f2 | awk '{ print ($1 > 0.25 && $1 < 0.31) }'
  1
  $ head -1 log.csv | cut -d, -f9-
  in.console.imu,in.console.lidar 36,in.console.lidar 4,out.forward,out.turn
  $ grep -c 'Scan {ranges = .*Nothing' log.csv | awk '{ print ($1 > 10) }'
  1
  $ grep -c 'Imu {rate = Vec3 {x = 0, y = 0, z = 0.25}' log.csv | awk '{ print ($1 > 10) }'
  1
  $ faults=no_angle=0.3; run_once approach.frob $patient --for 1s; cat messages
  warning: a message on /scan is ignored: its angles are not finite numbers, or angle_increment is 0

Without a robot, the program waits; it names the topic.

  $ rm messages
  $ FAKE_ROS="silent=0 alone=0" frobc run --ros2 drive.frob >summary 2>messages & run=$!
  $ until_true '[ -e messages ] && grep -q warning messages'; kill -INT $run; wait $run
  [4]
  $ cat messages
  warning: no node publishes /odom (nav_msgs/msg/Odometry), which the program needs. Start the robot's nodes, or remap the topic with `--ros-args -r odom:=NAME`
  interrupted at 0.000 s: the summary covers the run until then; run the same command again to start over
  error: the run was ended by an interrupt; sent a stop command to the robot
  $ grep '^steps' summary
  steps: 0

Conflicts with other nodes are reported:

  $ speeds="0 0.2 0"
  $ run_node 1.5s "other_type=0 wants_stamped=0 same_name=0"; cat messages
  warning: /odom has two types, so no message gets through: the node base publishes geometry_msgs/msg/PoseStamped, but this program needs nav_msgs/msg/Odometry
  warning: /cmd_vel has two types, so no message gets through: the node base subscribes to geometry_msgs/msg/TwistStamped, but this program needs geometry_msgs/msg/Twist; add `--set stamped=1`
  warning: there is another node named /drive; rename this one with `--ros-args -r __node:=NAME`

  $ run_node 1.5s wants_old=0; cat messages
  warning: the node base subscribes to /cmd_vel with the durability `transient local`, so no message gets through: old velocities are not kept. Set the durability of its subscription to `volatile`

The process of the node crashes. Another one is started, and stops the robot
before the program continues.

  $ speeds="0 0.2 0 0.2 0"
  $ run_node 0.9s crash=0.5; cat messages velocities
  0.000 0.000
  0.200 0.000
  0.000 0.000
  0.200 0.000
  0.000 0.000

The robot is stopped when any part of a run ends or is suspended.

  $ frobc build --ros2 drive.frob
  $ FAKE_ROS=crash=0.5 ./drive --reconnect 0 >summary
  error: lost the connection to the robot: the process of the ROS 2 node has ended; the robot could not be reached to stop it
  [4]
  $ start_node; kill -INT $run; wait $run; until_stopped
  last velocity: 0.000 0.000
  $ start_node; kill -KILL $controller; wait $run; until_stopped
  last velocity: 0.000 0.000
  $ tail -1 messages
  error: the controller was killed by signal 9 (Killed); sent a stop command to the robot
  $ start_node; kill -KILL $run; until_stopped
  last velocity: 0.000 0.000
  $ start_node; kill -KILL -$run; until_stopped
  last velocity: 0.000 0.000
  $ start_node; kill -STOP $run; until_stopped
  last velocity: 0.000 0.000
  $ kill -KILL $run

None of these processes survives.

  $ until_true '! pgrep -f "^[^ ]*drive --ros-node" >/dev/null'

Mistakes on the command line:

  $ AMENT_PREFIX_PATH= frobc run --ros2 drive.frob 2>&1 | sed 's/`source .*`/`source …`/'
  error: there is no ROS 2 in this shell: install it, and source its setup script, as in `source …`, which sets AMENT_PREFIX_PATH
  $ rm prefix/share/ament_index/resource_index/packages/*_msgs
  $ ROS_DISTRO=jazzy frobc run --ros2 drive.frob
  error: ROS 2 in this shell (AMENT_PREFIX_PATH) lacks the packages geometry_msgs, nav_msgs, sensor_msgs, diagnostic_msgs, std_msgs, visualization_msgs, lifecycle_msgs and rosgraph_msgs: install them, as in `sudo apt install ros-jazzy-geometry-msgs ros-jazzy-nav-msgs ros-jazzy-sensor-msgs ros-jazzy-diagnostic-msgs ros-jazzy-std-msgs ros-jazzy-visualization-msgs ros-jazzy-lifecycle-msgs ros-jazzy-rosgraph-msgs`
  [2]
  $ rm prefix/share/ament_index/resource_index/packages/rcl
  $ sh fake/build.sh fake "$PWD/prefix"
  $ sed -i 's/9.2.8/5.3.1/' prefix/share/rcl/package.xml
  $ speeds="0 0.2 0"
  $ run_node 0.1s ""; cat messages
  warning: frobc is tested with ROS 2 Jazzy and Kilted, but not with the installation in this shell, which has rcl 5.3.1
  $ frobc run --ros2 --robot scout drive.frob
  error: --ros2 is for the robot `ros`, not for `scout`: remove --robot
  [2]
  $ frobc run --ros2 --device /dev/ttyUSB0 drive.frob
  error: a robot cannot be both on a serial line and in ROS 2: remove --device or --ros2
  [2]
  $ frobc run drive.frob --ros-args -r odom:=odometry
  error: --ros-args only works with --ros2: add --ros2, or remove --ros-args
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
  warning: frobc is tested with ROS 2 Jazzy and Kilted, but not with the installation in this shell, which has rcl 5.3.1
  error[E0503]: `main` is a program for `pioneer`, not for `ros`
   --> pioneer.frob:3:1
    |
  3 | main = reactimateRobot (constant restingOutput)
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: allow any robot, as in `main :: (HasSonar i, DiffDrive o) => Program i o`
  
  1 error
  [1]

  $ ./drive --help | head -13
  usage: drive [OPTION]... [--ros-args ARG...]
  
  Runs the program drive.
  
    --lifecycle        be a managed node: wait until other nodes configure and activate it
    --ros-args ARG... [--]
                       arguments for ROS 2, up to `--`, such as `-r odom:=NAME` to remap
                       a topic, or `-r __node:=NAME` to rename the node
    --for SECONDS      how long to run (until interrupted)
    --rate HZ          how often the controller runs (50, or the rate of `node`)
    --record FILE.csv  record the inputs and outputs of the program (FILE.csv.gz: compressed)
    --patience SECONDS maximum age of a reading, and maximum duration of a step,
                       before the robot is stopped (0.2)
