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

A text is an enumeration with an instance of `RosText`. A message with an
unknown text is ignored, or read with `Nothing` if the field is a `Maybe`; each
unknown text is reported once.

  $ cat >modes.frob <<END
  > import Ros
  > data Mode = Idle | Driving
  > instance RosText Mode where
  >     rosText mode = case mode of
  >         Idle -> "idle"
  >         Driving -> "driving!"
  > data In = In { mode :: Event Mode }
  > data Out = Out { state :: Event Mode }
  > main :: Program In Out
  > main = node 50[Hz] (proc i -> Out { state = i.mode })
  > END
  $ export FAKE_ROS_WORDS="driving! blink driving! blink blonk idle"
  $ speeds=""; run_ros modes.frob --for 1.5s --record log.csv; cat messages; uniq velocities
  warning: a message on /mode is ignored: its `data` is "blink", but `Mode` only has the texts "idle" and "driving!"; add a constructor, or declare the field as a `Maybe Mode`
  warning: a message on /mode is ignored: its `data` is "blonk", but `Mode` only has the texts "idle" and "driving!"; add a constructor, or declare the field as a `Maybe Mode`
  driving!
  idle
  $ grep -v ',,' log.csv | cut -d, -f2- | uniq
  in.mode,out.state
  Driving,Driving
  Idle,Idle
  $ frobc trace modes.frob --input log.csv | cut -d, -f2- >again; cut -d, -f3- log.csv | grep -v '^#' | cmp - again
  $ sed -i 's/Event Mode/Event (Maybe Mode)/' modes.frob
  $ run_ros modes.frob --for 1.5s --record log.csv; cat messages; grep -v ',,' log.csv | cut -d, -f2- | uniq
  warning: a message on /mode is read with `Nothing`: its `data` is "blink", but `Mode` only has the texts "idle" and "driving!"
  warning: a message on /mode is read with `Nothing`: its `data` is "blonk", but `Mode` only has the texts "idle" and "driving!"
  in.mode,out.state
  Just Driving,Just Driving
  Nothing,Nothing
  Just Driving,Just Driving
  Nothing,Nothing
  Just Idle,Just Idle

A node may have no outputs, for example to check assertions, and no inputs.

  $ cat >watch.frob <<END
  > import Ros
  > data In = In { enable :: Event Bool }
  > main :: Program In ()
  > main = watched where
  >     watched = node 50[Hz] watch
  > watch :: SF In ()
  > watch = proc i -> () where
  >     assert "is never enabled" (not (hold False i.enable))
  > END
  $ faults="enable=0.5" run_ros watch.frob --for 1.2s; head -1 summary; sort -u velocities; grep assert summary messages | sed 's/at [0-9].*/at …/'
  robot: node /watch, subscribes to /enable
  diagnostics: 0, watch: is never enabled: held
  diagnostics: 2, watch: is never enabled: violated
  summary:assert "is never enabled": violated, first at …
  $ sed 's/Program In ()/Program () ()/; s/SF In/SF ()/; s/proc i -> () where/constant ()/; /assert/d; /^data/d' watch.frob >idle.frob
  $ run_ros idle.frob --for 0.2s; head -1 summary
  robot: node /idle

Its tests and its recordings need no ROS.

  $ cat >tested.frob <<END
  > import Ros
  > import Trial
  > data In = In { enable :: Event Bool }
  > data Out = Out { cmdVel :: Twist }
  > main :: Program In Out
  > main = node 50[Hz] drive
  > drive :: SF In Out
  > drive = proc i -> Out { cmdVel = twist (if hold False i.enable then 0.2[m/s] else 0) 0 }
  > test "stands at first" = during 1[s] (proc () -> (drive (In { enable = NoEvent })).cmdVel == twist 0 0)
  > test "a drive" = trace "in.csv" "out.csv"
  > trial "stands" = Trial { world = "room.toml", lasts = 2[s], seeds = 1 \`to\` 2, judge = constant Holds }
  > END
  $ printf 'time,in.enable\n0,\n0.1,True\n' >in.csv
  $ frobc test tested.frob --update; frobc test tested.frob
  ok    stands at first: 1 s
  ok    a drive: 0.1 s; wrote out.csv
  FAIL  stands: tested is a ROS 2 node with topics of its own, not a program for a robot: use `frobc run --ros2`; without ROS, `frobc trace` runs it on recorded input, and `frobc test` runs its tests (`test`, not `trial`)
  3 tests: 1 failed
  ok    stands at first: 1 s
  ok    a drive: 0.1 s
  FAIL  stands: tested is a ROS 2 node with topics of its own, not a program for a robot: use `frobc run --ros2`; without ROS, `frobc trace` runs it on recorded input, and `frobc test` runs its tests (`test`, not `trial`)
  3 tests: 1 failed
  [1]

It is no program for a robot, so only ROS 2 runs it.

  $ frobc run enabled.frob
  error: enabled is a ROS 2 node with topics of its own, not a program for a robot: use `frobc run --ros2`; without ROS, `frobc trace` runs it on recorded input, and `frobc test` runs its tests (`test`, not `trial`)
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
    = hint: use Bool, Int, Float, an enumeration, an array or a record of these, or `Upto` for a sequence; or omit the field, so that messages contain its default value
  
  error[E0509]: the field `goal` of `In` is not a topic: `Maybe Pose` is not a message type
   --> wrong.frob:4:24
    |
  4 | data In = In { goal :: Maybe Pose, x' :: Int, odd :: Event Odd, cmdVel :: Int, cmd_vel :: Int, e :: () }
    |                        ^^^^^^^^^^
    |
    = hint: use Bool, Int, Float, an enumeration with an instance of `RosText`, or a record with an instance of `Message`, such as those in the module Ros; `frobc ros2 import PACKAGE/Type` writes the record for any other message
  
  error[E0509]: the field `x'` of `In` is not a topic: a topic's name cannot contain `'`
   --> wrong.frob:4:42
    |
  4 | data In = In { goal :: Maybe Pose, x' :: Int, odd :: Event Odd, cmdVel :: Int, cmd_vel :: Int, e :: () }
    |                                          ^^^
    |
    = hint: rename the field
  
  error[E0509]: the fields `cmdVel` and `cmd_vel` have the same topic, cmd_vel
   --> wrong.frob:4:91
    |
  4 | data In = In { goal :: Maybe Pose, x' :: Int, odd :: Event Odd, cmdVel :: Int, cmd_vel :: Int, e :: () }
    |                                                                                           ^^^
    |
    = hint: rename one of them
  
  error[E0509]: the field `e` of `In` cannot be a topic: `()` carries no data that a message could contain
   --> wrong.frob:4:101
    |
  4 | data In = In { goal :: Maybe Pose, x' :: Int, odd :: Event Odd, cmdVel :: Int, cmd_vel :: Int, e :: () }
    |                                                                                                     ^^
    |
    = hint: write `Event ()` for messages of the type std_msgs/msg/Empty
  
  error[E0509]: the field `vel` of `Out` is not a topic: `Counted Twist` is not a message type
   --> wrong.frob:5:25
    |
  5 | data Out = Out { vel :: Event (Counted Twist) }
    |                         ^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: use Bool, Int, Float, an enumeration with an instance of `RosText`, or a record with an instance of `Message`, such as those in the module Ros; `frobc ros2 import PACKAGE/Type` writes the record for any other message
  
  error[E0509]: the instance of `Odd` does not name a message type
   --> wrong.frob:6:10
    |
  6 | instance Message Odd where
    |          ^^^^^^^^^^^
    |
    = hint: return the name as a string literal, as in `rosType _ = "geometry_msgs/msg/Twist"`
  
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
  error[E0508]: the rate of a node must be between 0.1 and 1000 Hz, not 2000 Hz
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

A record that does not match its type of messages is refused, as far as its
definition is known: here those of common packages.

  $ cat >unlike.frob <<END
  > import Ros
  > data Odd = Odd { x :: Int, height :: Float, yy :: Float }
  > instance Message Odd where
  >     rosType _ = "geometry_msgs/msg/Point"
  > data Cov = Cov { orientationCovariance :: Array 3 Float, angularVelocity :: Quaternion }
  > instance Message Cov where
  >     rosType _ = "sensor_msgs/msg/Imu"
  > data Rays = Rays { ranges :: Float, angleMin :: Upto 3 Float, header :: Float }
  > instance Message Rays where
  >     rosType _ = "sensor_msgs/msg/LaserScan"
  > data Plain = Plain { data_ :: Float }
  > instance Message Plain where
  >     rosType _ = "std_msgs/msg/String"
  > data Unnamed = A | B
  > data Named = Named { data_ :: Unnamed }
  > instance Message Named where
  >     rosType _ = "std_msgs/msg/String"
  > data Same = C | D | E
  > instance RosText Same where
  >     rosText x = case x of
  >         C -> "c"
  >         _ -> "d"
  > data Guarded = F | G
  > instance RosText Guarded where
  >     rosText x = if x == F then "f" else "g"
  > data In = In
  >     { odd :: Event Odd, cov :: Event Cov, rays :: Event Rays, plain :: Event Plain
  >     , named :: Event Named, same :: Event Same, guarded :: Event Guarded, again :: Event Odd }
  > main :: Program In Twist
  > main = node 50[Hz] (proc _ -> twist 0 0)
  > END
  $ frobc check unlike.frob
  error[E0510]: the field `x` of `Odd` is `Int`, but geometry_msgs/msg/Point has `float64 x`
   --> unlike.frob:2:23
    |
  2 | data Odd = Odd { x :: Int, height :: Float, yy :: Float }
    |                       ^^^
    |
    = hint: declare it as `x :: Float`, with any unit
  
  error[E0510]: geometry_msgs/msg/Point has no field for `height` of `Odd`
   --> unlike.frob:2:28
    |
  2 | data Odd = Odd { x :: Int, height :: Float, yy :: Float }
    |                            ^^^^^^
    |
    = hint: remove it, or give it the name of one of the message's fields: x, y and z
  
  error[E0510]: geometry_msgs/msg/Point has no field for `yy` of `Odd`
   --> unlike.frob:2:45
    |
  2 | data Odd = Odd { x :: Int, height :: Float, yy :: Float }
    |                                             ^^
    |
    = hint: did you mean `y`?
  
  error[E0510]: the field `orientationCovariance` of `Cov` is `Array 3 Float`, but sensor_msgs/msg/Imu has `float64[9] orientation_covariance`
   --> unlike.frob:5:43
    |
  5 | data Cov = Cov { orientationCovariance :: Array 3 Float, angularVelocity :: Quaternion }
    |                                           ^^^^^^^^^^^^^
    |
    = hint: declare it as `orientationCovariance :: Array 9 Float`, with any unit
  
  error[E0510]: the field `angularVelocity` of `Cov` is `Quaternion`, but sensor_msgs/msg/Imu has `geometry_msgs/Vector3 angular_velocity`
   --> unlike.frob:5:77
    |
  5 | data Cov = Cov { orientationCovariance :: Array 3 Float, angularVelocity :: Quaternion }
    |                                                                             ^^^^^^^^^^
    |
    = hint: declare it as `angularVelocity :: Vec3[m]`, with any unit
  
  error[E0510]: the field `ranges` of `Rays` is `Float`, but sensor_msgs/msg/LaserScan has `float32[] ranges`
   --> unlike.frob:8:30
    |
  8 | data Rays = Rays { ranges :: Float, angleMin :: Upto 3 Float, header :: Float }
    |                              ^^^^^
    |
    = hint: declare it as `ranges :: Upto 16 Float`, with any unit
  
  error[E0510]: the field `angleMin` of `Rays` is `Upto 3 Float`, but sensor_msgs/msg/LaserScan has `float32 angle_min`
   --> unlike.frob:8:49
    |
  8 | data Rays = Rays { ranges :: Float, angleMin :: Upto 3 Float, header :: Float }
    |                                                 ^^^^^^^^^^^^
    |
    = hint: declare it as `angleMin :: Float`, with any unit
  
  error[E0510]: the field `header` of `Rays` is `Float`, but sensor_msgs/msg/LaserScan has `std_msgs/Header header`
   --> unlike.frob:8:73
    |
  8 | data Rays = Rays { ranges :: Float, angleMin :: Upto 3 Float, header :: Float }
    |                                                                         ^^^^^
    |
    = hint: declare it as `header :: Header Frame`, where `Frame` is an enumeration with an instance of `RosText`
  
  error[E0510]: the field `data_` of `Plain` is `Float`, but std_msgs/msg/String has `string data`
    --> unlike.frob:11:31
     |
  11 | data Plain = Plain { data_ :: Float }
     |                               ^^^^^
     |
     = hint: declare strings as an enumeration with an instance of `RosText`, or omit the field
  
  error[E0509]: the field `data_` of `Named` cannot be a string in messages: `Unnamed` has no instance of `RosText`
    --> unlike.frob:15:31
     |
  15 | data Named = Named { data_ :: Unnamed }
     |                               ^^^^^^^
     |
     = hint: write `instance RosText Unnamed where`, with a string for each constructor
  
  error[E0509]: two constructors of `Same` have the string "d"
    --> unlike.frob:19:10
     |
  19 | instance RosText Same where
     |          ^^^^^^^^^^^^
     |
     = hint: give each constructor a different string
  
  error[E0509]: the instance of `Guarded` does not list its strings
    --> unlike.frob:24:10
     |
  24 | instance RosText Guarded where
     |          ^^^^^^^^^^^^^^^
     |
     = hint: write `rosText x = case x of`, and below it a line for each constructor, as in `F -> "f"`
  
  error[E0509]: `main` is a node, which returns a record of topics; `Twist` is a message
    --> unlike.frob:30:1
     |
  30 | main = node 50[Hz] (proc _ -> twist 0 0)
     | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
     |
     = hint: declare a record with a field for each topic, as in `data Out = Out { cmdVel :: Twist }`; the field's name is the topic's
  
  13 errors
  [1]

The definitions of the sourced ROS 2 count first, also those of other packages.

  $ mkdir -p sourced/share/my_msgs/msg; printf 'int32 left  # [rad/s]\nstring name\n' >sourced/share/my_msgs/msg/Wheels.msg
  $ cat >wheels.frob <<END
  > import Ros
  > data Wheels = Wheels { left, right :: Float[rad/s] }
  > instance Message Wheels where
  >     rosType _ = "my_msgs/msg/Wheels"
  > data In = In { wheels :: Event Wheels }
  > main :: Program In ()
  > main = node 50[Hz] (constant ())
  > END
  $ frobc check wheels.frob
  $ AMENT_PREFIX_PATH=$PWD/sourced frobc check wheels.frob
  error[E0510]: my_msgs/msg/Wheels has no field for `right` of `Wheels`
   --> wheels.frob:2:30
    |
  2 | data Wheels = Wheels { left, right :: Float[rad/s] }
    |                              ^^^^^
    |
    = hint: remove it, or give it the name of one of the message's fields: left and name
  
  error[E0510]: the field `left` of `Wheels` is `Float[1/s]`, but my_msgs/msg/Wheels has `int32 left`
   --> wheels.frob:2:39
    |
  2 | data Wheels = Wheels { left, right :: Float[rad/s] }
    |                                       ^^^^^^^^^^^^
    |
    = hint: declare it as `left :: Int`
  
  2 errors
  [1]
  $ sed -i 's/Wheels"/Wheel"/' wheels.frob; AMENT_PREFIX_PATH=$PWD/sourced frobc check wheels.frob
  error[E0510]: the package my_msgs of the sourced ROS 2 installation has no message Wheel
   --> wheels.frob:3:10
    |
  3 | instance Message Wheels where
    |          ^^^^^^^^^^^^^^
    |
    = hint: did you mean `my_msgs/msg/Wheels`?
  
  1 error
  [1]
  $ echo 'int32' >sourced/share/my_msgs/msg/Wheel.msg; AMENT_PREFIX_PATH=sourced frobc check wheels.frob
  error[E0510]: sourced/share/my_msgs/msg/Wheel.msg:1: neither a field nor a constant of a message: int32
   --> wheels.frob:3:10
    |
  3 | instance Message Wheels where
    |          ^^^^^^^^^^^^^^
    |
    = hint: correct the definition
  
  1 error
  [1]

The exported package depends on the packages of the messages.

  $ sed 's/Event Bool }$/Event Bool, level :: Event Level }/; /^data Out/s/, level.*/ }/; s/^-- Dr/data Level = Level { value :: Int }\ninstance Message Level where\n    rosType _ = "my_msgs\/msg\/Level"\n-- Dr/' enabled.frob >levels.frob
  $ frobc export levels.frob --ros2 package; grep exec_depend package/package.xml; grep remappings package/launch/levels.launch.py
    <exec_depend>my_msgs</exec_depend>
    <exec_depend>ros2launch</exec_depend>
              remappings=[("blocked", "blocked"), ("cmd_vel", "cmd_vel"), ("enable", "enable"), ("level", "level")],
