Other nodes operate the program's console: they press its buttons, and a joystick
holds buttons and moves knobs. Here with the fake ROS 2, in which a button is pressed and the
joystick moves at given times.

  $ . ./ros.sh
  $ cat >held.frob <<END
  > import Robot
  > main :: (HasConsole i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (speed i) (turn i))) where
  >     speed i = if buttonHeld "drive" i then knob "pace" 0 0.6[m/s] 0.2[m/s] i else 0
  >     turn = proc i -> if hold False (tag (buttonPressed "go left!" i) True) then 0.5[rad/s] else 0
  > END
  $ turns_are() { awk '/^[0-9]/ { printf "%s%g", (n++ > 0 ? " " : ""), $2 }' velocities; }
  $ speeds="0 0 0"; faults="joy=9 press=0.6"; run_ros held.frob --for 1.5s; cat messages; turns_are
  warning: nothing can press the button `drive`: add `--set "joy.drive=NUMBER"` for a joystick button, or `--view --control`
  0 0.5 0
  $ joystick="--set joy.drive=1 --set joy.pace=0"
  $ speeds="0 0.4 0"; faults="joy=0.5"; run_ros held.frob $joystick --for 1.5s; cat messages
  $ run_once held.frob --set "joy.go left!=1" --set joy.drive=0 --for 0.1s; cat messages

If the joystick is silent, all its buttons are released. Its messages can be unusable.

  $ faults="joy=0.5 joy_silent=1"; run_ros held.frob $joystick --for 3s; cat messages
  $ warned () { run_once held.frob $joystick --for 1s; cat messages; }
  $ faults="joy_small=0"; warned
  warning: a message on /joy is ignored: `joy.drive=1` needs 2 buttons, but the joystick has 1: change this setting
  $ faults="joy_nan=0"; warned
  warning: a message on /joy is ignored: an axis is not a finite number

A press before the program runs is ignored.

  $ rm messages; FAKE_ROS="silent=0 press=0.3" frobc run --ros2 held.frob $joystick >summary 2>messages &
  $ until_true '[ -e messages ] && grep -q ignored messages'; kill -INT $!; wait $!; grep ignored messages
  warning: a press of the button `go left!` is ignored, because the program is not running

Settings for other controls are refused, and so are buttons with the same topic.

  $ frobc run --ros2 held.frob --set joy.stop=1
  error: a joystick cannot operate `stop`: held has no button or knob with this name; its buttons and knobs are `go left!`, `drive`, `pace`
  [2]
  $ frobc run --ros2 held.frob --set joy.drive=left
  error: `joy.drive` must be the number of a button of the joystick, from 0 to 63: write `--set "joy.drive=0"`
  [2]
  $ frobc run --ros2 held.frob --set joy.pace=64
  error: `joy.pace` must be the number of an axis of the joystick, from 0 to 63: write `--set "joy.pace=0"`
  [2]
  $ cat >lamp.frob <<END
  > import Robot
  > main :: (HasConsole i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (if toggle "lamp" False i then 1[cm/s] else 0) 0))
  > END
  $ frobc run --ros2 lamp.frob --set joy.lamp=1
  error: a joystick cannot operate `lamp`: it is a toggle, which is a parameter of the node: add `--ros-args -p NAME:=true`, or use `ros2 param set`
  [2]
  $ frobc run --ros2 lamp.frob --set joy.stop=1
  error: a joystick cannot operate `stop`: lamp has no buttons or knobs
  [2]
  $ sed 's/"drive"/"go_left_"/; s/buttonHeld/buttonPressed/; s/speed i = if \(.*\) then/speed = proc i -> if hold False (tag (\1) True) then/' held.frob >same.frob
  $ frobc run --ros2 same.frob
  error: cannot subscribe: the buttons `go_left_` and `go left!` of the program have the same topic, ~/buttons/go_left_: rename one of them
  [2]
