Only `import Robot` makes the robot `ros` an instance of classes such as `HasImu`, because the
module `Ros` imports the modules of these classes. So the import is used even if no name in it is.

  $ cat > imu.frob <<'FROB'
  > import Imu
  > import Robot
  > main :: HasImu i => SF i AngularVelocity
  > main = gyroRate
  > FROB
  $ frobc check --robot ros imu.frob
  $ sed '/import Robot/d' imu.frob > without.frob
  $ frobc check --robot ros without.frob
  error[E0503]: `ros` has no `HasImu` here, because the program does not import its module
   --> without.frob:3:8
    |
  3 | main = gyroRate
    |        ^^^^^^^^ `gyroRate` needs it
    |
    = hint: add `import Robot`, which contains the capabilities of all robots
  
  1 error
  [1]
  $ frobc check --robot pioneer without.frob

An import that provides neither names nor instances that the program can use:

  $ cat > unused.frob <<'FROB'
  > import Control
  > import Robot
  > main :: SF Float Float
  > main = lowPass 1[s]
  > FROB
  $ frobc check unused.frob
  warning[W0306]: `Robot` is imported, but nothing from it is used
   --> unused.frob:2:1
    |
  2 | import Robot
    | ^^^^^^^^^^^^
    |
    = hint: remove it
  
  1 warning
