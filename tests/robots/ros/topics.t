A node with topics of its own: here with a fake ROS 2, in which another node
publishes /enable (fake/fake_ros.c).

  $ . ./ros.sh

Each field of its input and output is a topic. A plain output is published in
each instant, an event when it occurs. At its end, the node publishes zero as
a command.

  $ speeds="0 0.2 0" faults="enable=0.5 disable=1.5"
  $ run_ros enabled.frob --for 2s --record log.csv; head -1 summary; cat messages; uniq velocities
  robot: node /enabled, subscribes to /enable, publishes /cmd_vel, /blocked
  0.000 0.000
  0.200 0.000
  not blocked
  0.000 0.000
  blocked
  $ head -1 log.csv
  time,in.enable,out.cmdVel.linear.x,out.cmdVel.linear.y,out.cmdVel.linear.z,out.cmdVel.angular.x,out.cmdVel.angular.y,out.cmdVel.angular.z,out.blocked
  $ frobc trace enabled.frob --input log.csv | cut -d, -f2- >again; cut -d, -f3- log.csv | grep -v '^#' | cmp - again
  $ awk -F, 'NR > 1 { n++ } END { print (n >= 80 && n <= 120) }' log.csv
  1

The program determines the rate, unless `--rate` does.

  $ run_ros enabled.frob --for 2s --rate 10 --record log.csv; awk -F, 'END { print (NR >= 16 && NR <= 24) }' log.csv
  1

Topics are remapped like those of a robot.

  $ run_ros enabled.frob --for 2s --ros-args -r cmd_vel:=base/cmd_vel -r __node:=mover --; head -1 summary
  robot: node /mover, subscribes to /enable, publishes /base/cmd_vel, /blocked

The node stops what it commands when it is killed.

  $ frobc build enabled.frob --ros2
  $ : >velocities; FAKE_ROS="enable=0" ./enabled --patience 1 >summary 2>messages & run=$!
  $ until_true 'grep -q "^0.200" velocities'; kill -KILL $run; until_stopped
  last velocity: 0.000 0.000

It is no program for a robot, so only ROS 2 runs it.

  $ frobc run enabled.frob
  error: enabled is a ROS 2 node with topics of its own, not a program for a robot: use `frobc run --ros2`; `frobc trace` runs it on recorded input
  [2]
  $ frobc run enabled.frob --device /dev/ttyUSB0
  error: enabled is a ROS 2 node with topics of its own, not a program for a robot: use `frobc run --ros2`; `frobc trace` runs it on recorded input
  [2]
  $ frobc run enabled.frob --ros2 --robot pioneer
  error: --ros2 is for the robot `ros`, not for `pioneer`: remove --robot
  [2]
  $ cat >plain.frob <<END
  > import Robot
  > data In = In { x :: Float }
  > data Out = Out { y :: Float }
  > main :: Program In Out
  > main = reactimateRobot (proc i -> Out { y = i.x })
  > END
  $ frobc run plain.frob --ros2
  error: plain is neither a robot program nor a node: use `reactimateRobot` for the robot `ros`, or `node 50[Hz]` if its input and output are records of topics
  [2]

Fields that are not topics are named.

  $ cat >wrong.frob <<END
  > import Geometry
  > import Ros
  > data Odd = Odd { a :: Maybe Int }
  > data In = In { goal :: Maybe Pose, x' :: Int, odd :: Event Odd, cmdVel :: Int, cmd_vel :: Int, e :: () }
  > data Out = Out { vel :: Event (Counted Twist) }
  > instance Message Odd where
  >     rosType _ = "odd_msgs/Odd"
  > main :: Program In Out
  > main = node 50[Hz] (proc _ -> Out { vel = NoEvent })
  > END
  $ frobc check wrong.frob
  error[E0509]: the field `a` of `Odd` cannot be part of a message: its type is `Maybe Int`
   --> wrong.frob:3:23
    |
  3 | data Odd = Odd { a :: Maybe Int }
    |                       ^^^^^^^^^
    |
    = hint: fields of messages are Bool, Int, Float, arrays and records of them, and `Upto` for sequences; leave the field out, and the message has its default there
  
  error[E0509]: the field `goal` of `In` is not a topic: `Maybe Pose` is not a type of messages
   --> wrong.frob:4:24
    |
  4 | data In = In { goal :: Maybe Pose, x' :: Int, odd :: Event Odd, cmdVel :: Int, cmd_vel :: Int, e :: () }
    |                        ^^^^^^^^^^
    |
    = hint: messages are Bool, Int, Float, and records with an instance of `Message`, such as those of the module Ros; `frobc ros2 import PACKAGE/Type` writes the record of any other message
  
  error[E0509]: the field `x'` of `In` is not a topic: a topic's name cannot contain `'`
   --> wrong.frob:4:42
    |
  4 | data In = In { goal :: Maybe Pose, x' :: Int, odd :: Event Odd, cmdVel :: Int, cmd_vel :: Int, e :: () }
    |                                          ^^^
    |
    = hint: rename the field
  
  error[E0509]: the fields `cmdVel` and `cmd_vel` are the same topic, cmd_vel
   --> wrong.frob:4:91
    |
  4 | data In = In { goal :: Maybe Pose, x' :: Int, odd :: Event Odd, cmdVel :: Int, cmd_vel :: Int, e :: () }
    |                                                                                           ^^^
    |
    = hint: rename one of them
  
  error[E0509]: the field `e` of `In` is not a topic: `()` has no value that a message could change
   --> wrong.frob:4:101
    |
  4 | data In = In { goal :: Maybe Pose, x' :: Int, odd :: Event Odd, cmdVel :: Int, cmd_vel :: Int, e :: () }
    |                                                                                                     ^^
    |
    = hint: write `Event ()`, for messages of the type std_msgs/msg/Empty
  
  error[E0509]: the field `vel` of `Out` is not a topic: `Counted Twist` is not a type of messages
   --> wrong.frob:5:25
    |
  5 | data Out = Out { vel :: Event (Counted Twist) }
    |                         ^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: messages are Bool, Int, Float, and records with an instance of `Message`, such as those of the module Ros; `frobc ros2 import PACKAGE/Type` writes the record of any other message
  
  error[E0509]: the instance of `Odd` does not name a type of messages
   --> wrong.frob:6:10
    |
  6 | instance Message Odd where
    |          ^^^^^^^^^^^
    |
    = hint: return the name itself, as in `rosType _ = "geometry_msgs/msg/Twist"`
  
  7 errors
  [1]
  $ cat >robot.frob <<END
  > import Robot
  > import Ros
  > main :: DiffDrive o => Program i o
  > main = node 50[Hz] (proc _ -> roMake (setVelTR 0 0))
  > END
  $ frobc check robot.frob --robot ros
  error[E0509]: `main` is a node, which reads a record of topics, not `i`
   --> robot.frob:4:1
    |
  4 | main = node 50[Hz] (proc _ -> roMake (setVelTR 0 0))
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: declare a record with a field for each topic, as in `data In = In { enable :: Event Bool }`
  
  1 error
  [1]
  $ cat >fast.frob <<END
  > import Ros
  > data Out = Out { level :: Int }
  > main :: Program Float Out
  > main = node 2000[Hz] (constant (Out { level = 1 }))
  > END
  $ frobc check fast.frob
  error[E0508]: the rate of a node is between 0.1 and 1000 Hz, not 2000 Hz
   --> fast.frob:4:8
    |
  4 | main = node 2000[Hz] (constant (Out { level = 1 }))
    |        ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: write a rate such as `50[Hz]`
  
  1 error
  [1]
  $ sed -i 's/2000/20/' fast.frob; frobc check fast.frob
  error[E0509]: `main` is a node, which reads a record of topics, not `Float`
   --> fast.frob:4:1
    |
  4 | main = node 20[Hz] (constant (Out { level = 1 }))
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: declare a record with a field for each topic, as in `data In = In { enable :: Event Bool }`
  
  1 error
  [1]

The exported package depends on the packages of the messages.

  $ sed 's/Event Bool }$/Event Bool, level :: Event Level }/; /^data Out/s/, level.*/ }/; s/^-- Dr/data Level = Level { value :: Int }\ninstance Message Level where\n    rosType _ = "my_msgs\/msg\/Level"\n-- Dr/' enabled.frob >levels.frob
  $ frobc export levels.frob --ros2 package; grep exec_depend package/package.xml; grep remappings package/launch/levels.launch.py
    <exec_depend>my_msgs</exec_depend>
    <exec_depend>ros2launch</exec_depend>
              remappings=[("blocked", "blocked"), ("cmd_vel", "cmd_vel"), ("enable", "enable"), ("level", "level")],
