`frobc ros2 import` writes the module of a type of messages. It only reads the
definitions of the installed packages.

  $ export AMENT_PREFIX_PATH=$PWD/first:$PWD/second
  $ mkdir -p first/share/base_msgs/msg second/share/arm_msgs/msg
  $ cat >first/share/base_msgs/msg/Wheels.msg <<END
  > # The state of the wheels.
  > uint8 STOPPED=0
  > uint8 DRIVING = 1
  > string NOTE="a # in a text"
  > float32 GAIN=1.5
  > 
  > std_msgs/Header header
  > float64 left_speed    # [rad/s], positive ahead
  > float64 right_speed   # [rad/s]
  > # The distance that the robot has driven, in meters.
  > float32 driven
  > float64[4] gains
  > float32[] currents    # in A
  > uint8 state
  > uint32 type 5
  > string<=10 name
  > Motor[<=2] motors
  > geometry_msgs/Point place
  > geometry_msgs/Vector3 force  # (N)
  > builtin_interfaces/Time since
  > END
  $ cat >first/share/base_msgs/msg/Motor.msg <<END
  > bool is_on
  > int16 temperature
  > Label label
  > END
  $ echo 'string text' >first/share/base_msgs/msg/Label.msg
  $ frobc ros2 import base_msgs/Wheels --most 8
  WheelsMsg.frob: import it with `import WheelsMsg`
  $ cat WheelsMsg.frob
  -- Generated from the message base_msgs/msg/Wheels by `frobc ros2 import`.
  -- You can edit this file: remove fields, or change units and the sizes of sequences.
  module WheelsMsg where
  
  import Geometry (Point3, Vec3)
  import Ros (Message, Stamp, Upto)
  
  -- | The message base_msgs/msg/Motor.
  -- Omitted: base_msgs/Label label (it contains only text).
  data Motor = Motor
      { isOn :: Bool          -- bool
      , temperature :: Int    -- int16
      }
  
  instance Message Motor where
      rosType _ = "base_msgs/msg/Motor"
  
  -- | The message base_msgs/msg/Wheels.
  -- Omitted: std_msgs/Header header (the node sets the stamp).
  -- Omitted: string name (text: an enumeration with an instance of `RosText` could represent it).
  data Wheels = Wheels
      { leftSpeed :: Float[rad/s]      -- float64; [rad/s], positive ahead
      , rightSpeed :: Float[rad/s]     -- float64; [rad/s]
      , driven :: Float[m]             -- float32; The distance that the robot has driven, in meters.
      , gains :: Array 4 Float         -- float64[4]
      , currents :: Upto 8 Float[A]    -- float32[]; unbounded in ROS; in A
      , state :: Int                   -- uint8
      , type_ :: Int                   -- uint32; larger numbers become the nearest Int
      , motors :: Upto 2 Motor         -- base_msgs/Motor[<=2]
      , place :: Point3                -- geometry_msgs/Point
      , force :: Vec3[N]               -- geometry_msgs/Vector3; (N)
      , since :: Stamp                 -- builtin_interfaces/Time
      }
  
  instance Message Wheels where
      rosType _ = "base_msgs/msg/Wheels"
  
  -- | The constant STOPPED.
  wheelsStopped :: Int
  wheelsStopped = 0
  
  -- | The constant DRIVING.
  wheelsDriving :: Int
  wheelsDriving = 1
  
  -- | The constant GAIN.
  wheelsGain :: Float
  wheelsGain = 1.5
  $ frobc format --check WheelsMsg.frob

A node uses it.

  $ cat >node.frob <<END
  > import Ros
  > import WheelsMsg
  > data In = In { wheels :: Event Wheels }
  > data Out = Out { turning :: Bool }
  > main :: Program In Out
  > main = node 20[Hz] (proc i -> Out { turning = hold False (mapE turns i.wheels) }) where
  >     turns w = w.leftSpeed < w.rightSpeed && w.state == wheelsDriving
  > END
  $ frobc check node.frob

Mistakes:

  $ frobc ros2 import base_msgs/Wheels
  error: WheelsMsg.frob already exists: move it away, or write to another file with `-o OTHER.frob`
  [2]
  $ frobc ros2 import base_msgs/msg/Wheel -o Other.frob
  error: the package base_msgs has no message Wheel; did you mean base_msgs/Wheels?
  [2]
  $ frobc ros2 import leg_msgs/Leg
  error: ROS 2 in this shell (AMENT_PREFIX_PATH) has no package leg_msgs with messages: install it, or source the setup script of its workspace
  [2]
  $ frobc ros2 import Wheels
  error: write the package and the type of the message, as in my_msgs/Wheels, not `Wheels`
  [2]
  $ frobc ros2 import base_msgs/Label
  error: base_msgs/Label has no field that Frob can represent: it contains only text
  [2]
  $ printf 'float64 x\nfloat65 y\n' >second/share/arm_msgs/msg/Arm.msg; frobc ros2 import arm_msgs/Arm
  error: the field `y`: the package arm_msgs has no message float65, but Arm
  [2]
  $ printf 'leg_msgs/Leg leg\n' >second/share/arm_msgs/msg/Arm.msg; frobc ros2 import arm_msgs/Arm
  error: the field `leg`: ROS 2 in this shell (AMENT_PREFIX_PATH) has no package leg_msgs with messages: install it, or source the setup script of its workspace
  [2]
  $ AMENT_PREFIX_PATH= frobc ros2 import base_msgs/Wheels -o Other.frob
  error: ROS 2 is not set up in this shell: source its setup script, which sets AMENT_PREFIX_PATH, for example with `source /opt/ros/jazzy/setup.bash`
  [2]
