  $ ../../explain/message.exe W0315
  main.frob:
  import Geometry
  
  main :: SF (Pose, Angle) (AngularVelocity, Angle)
  main = proc (pose, goal) -> (derivative pose.heading, goal - pose.heading)
  
  warning[W0315]: `derivative` is applied to an angle that wraps
   --> main.frob:4:30
    |
  4 | main = proc (pose, goal) -> (derivative pose.heading, goal - pose.heading)
    |                              ^^^^^^^^^^ ------------ this angle is between -pi and pi
    |
    = note: when the angle jumps from pi to -pi, `derivative` sees a rotation of 360 degrees
    = hint: write `angularRate` (module Angles)
  
  warning[W0315]: this difference between two angles can be more than half a turn
   --> main.frob:4:55
    |
  4 | main = proc (pose, goal) -> (derivative pose.heading, goal - pose.heading)
    |                                                       ^^^^^^^^^^^^^^^^^^^
    |
    = note: from -179 degrees to 179 degrees, the difference is 358 degrees; the shortest rotation is -2 degrees
    = hint: write `angleDiff goal pose.heading` (module Geometry)
  
  2 warnings
