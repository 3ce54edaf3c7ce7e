A plain difference or filter of an angle that wraps is reported, with the function that takes the
wrap into account.

  $ cat > turns.frob <<'FROB'
  > import Control
  > import Filters
  > import Geometry
  > 
  > gains, noDerivative :: Pid[1, 1/s]
  > gains = Pid { kp = 2[1/s], ki = 0, kd = 0.1, largest = 1[rad/s] }
  > noDerivative = Pid { kp = 2[1/s], ki = 0, kd = 0, largest = 1[rad/s] }
  > 
  > main :: SF (Pose, Point2) (Float, Array 3 AngularVelocity, Array 3 Angle)
  > main = proc (pose, goal) -> (2 * wrong, [rate, turn, pid noDerivative error], [smooth, high, fused]) where
  >     toGoal = direction (goal ^-^ pose.position)
  >     error  = angleDiff toGoal pose.heading
  >     wrong  = toGoal - pose.heading
  >     rate   = derivative pose.heading
  >     turn   = pid gains error
  >     smooth = lowPass 0.2[s] (previous error)
  >     high   = highPass 1[s] (atan2 1 (wrong - 1))
  >     fused  = complementary 1[s] (turn, pose.heading)
  > FROB
  $ frobc check turns.frob
  warning[W0315]: this difference between two angles can be more than half a turn
    --> turns.frob:13:14
     |
  13 |     wrong  = toGoal - pose.heading
     |              ^^^^^^^^^^^^^^^^^^^^^
     |
     = note: from -179 degrees to 179 degrees, the difference is 358 degrees; the shortest rotation is -2 degrees
     = hint: write `angleDiff toGoal pose.heading` (module Geometry)
  
  warning[W0315]: `derivative` is applied to an angle that wraps
    --> turns.frob:14:14
     |
  14 |     rate   = derivative pose.heading
     |              ^^^^^^^^^^ ------------ this angle is between -pi and pi
     |
     = note: when the angle jumps from pi to -pi, `derivative` sees a rotation of 360 degrees
     = hint: write `angularRate` (module Angles)
  
  warning[W0315]: `pid` is applied to an angle that wraps
    --> turns.frob:15:14
     |
  15 |     turn   = pid gains error
     |              ^^^       ----- this angle is between -pi and pi
     |
     = note: when the angle jumps from pi to -pi, `pid` sees a rotation of 360 degrees
     = hint: make the angle continuous with `unwrap` (module Angles)
  
  warning[W0315]: `lowPass` is applied to an angle that wraps
    --> turns.frob:16:14
     |
  16 |     smooth = lowPass 0.2[s] (previous error)
     |              ^^^^^^^         -------------- this angle is between -pi and pi
     |
     = note: when the angle jumps from pi to -pi, `lowPass` sees a rotation of 360 degrees
     = hint: write `lowPassAngle` (module Angles)
  
  warning[W0315]: `highPass` is applied to an angle that wraps
    --> turns.frob:17:14
     |
  17 |     high   = highPass 1[s] (atan2 1 (wrong - 1))
     |              ^^^^^^^^       ------------------- this angle is between -pi and pi
     |
     = note: when the angle jumps from pi to -pi, `highPass` sees a rotation of 360 degrees
     = hint: make the angle continuous with `unwrap` (module Angles)
  
  warning[W0315]: `complementary` is applied to an angle that wraps
    --> turns.frob:18:14
     |
  18 |     fused  = complementary 1[s] (turn, pose.heading)
     |              ^^^^^^^^^^^^^             ------------ this angle is between -pi and pi
     |
     = note: when the angle jumps from pi to -pi, `complementary` sees a rotation of 360 degrees
     = hint: write `complementaryAngle` (module Angles)
  
  6 warnings

The fixes compile, and nothing is left to report.

  $ frobc fix --all turns.frob
  turns.frob:13:14: use `angleDiff` (W0315)
  turns.frob:14:14: write `angularRate` (W0315)
  turns.frob:15:14: use `unwrap` (W0315)
  turns.frob:16:14: write `lowPassAngle` (W0315)
  turns.frob:17:14: use `unwrap` (W0315)
  turns.frob:18:14: write `complementaryAngle` (W0315)
  $ frobc check turns.frob
  $ tail -n 8 turns.frob
      toGoal = direction (goal ^-^ pose.position)
      error  = angleDiff toGoal pose.heading
      wrong  = angleDiff toGoal pose.heading
      rate   = angularRate pose.heading
      turn   = pid gains (unwrap error)
      smooth = lowPassAngle 0.2[s] (previous error)
      high   = highPass 1[s] (unwrap (atan2 1 (wrong - 1)))
      fused  = complementaryAngle 1[s] (turn, pose.heading)

Where any number of turns is fine, nothing is reported: in the sine of a difference, directly or by
an equation that is used nowhere else, in an argument of `angleDiff`, in the heading of a pose, and
in a difference from a rotation.

  $ cat > fine.frob <<'FROB'
  > import Geometry
  > 
  > turned :: Pose -> Angle -> Pose
  > turned p a = p { heading = p.heading - a }
  > 
  > main :: SF (Pose, Angle) (Float, Float, Angle, Angle, Pose)
  > main = proc (Pose { position, heading }, goal) -> (sin (goal - heading), cos off, near, left, turned there goal) where
  >     off   = goal - heading
  >     near  = angleDiff (goal - heading) 0.1
  >     left  = angleDiff goal heading - 5[deg]
  >     there = Pose { position, heading = goal - heading }
  > FROB
  $ frobc check fine.frob

A heading that a pattern binds, and an equation that is also used elsewhere:

  $ cat > both.frob <<'FROB'
  > import Geometry
  > 
  > main :: SF (Pose, Angle) (Float, Angle, AngularVelocity)
  > main = proc (Pose { heading }, goal) -> (sin off, 2 * off, derivative heading) where
  >     off = goal - heading
  > FROB
  $ frobc check both.frob 2>&1 | grep -A 3 warning
  warning[W0315]: `derivative` is applied to an angle that wraps
   --> both.frob:4:60
    |
  4 | main = proc (Pose { heading }, goal) -> (sin off, 2 * off, derivative heading) where
  --
  warning[W0315]: this difference between two angles can be more than half a turn
   --> both.frob:5:11
    |
  5 |     off = goal - heading
  --
  2 warnings

The angle passes through sums, multiples, conditions, and functions that store or choose values. It
comes from the compass or a signal function in a composition. A multiple of a rotation is a command,
so nothing is reported for `command`.

  $ cat > ways.frob <<'FROB'
  > import Control
  > import Filters
  > import Geometry
  > import Imu
  > import Pid
  > import Robot
  > 
  > gains :: Pid[1, 1/s]
  > gains = Pid { kp = 2[1/s], ki = 0, kd = 0.1, largest = 1[rad/s] }
  > 
  > turns :: (HasImu i, HasOdometry i) => SF (i, Bool) (Array 5 AngularVelocity, Array 12 Angle)
  > turns = proc (i, b) ->
  >     ( [ pid2 (pidSettings gains) (0, h), pidWith (pidSettings gains) (pidInput 0 h), pid gains (compass + 0.1)
  >       , derivative (holdFinite 0 h), command ]
  >     , [ (stateVariable 2[Hz] 1 h).low, median (recent h :: Array 5 Angle), mean [h, 0.1]
  >       , lowPass 1[s] (imuHeading 2[s] i), lowPass 1[s] (h + 0.1), lowPass 1[s] (2 * h)
  >       , lowPass 1[s] (delayBy 0.5[s] h), lowPass 1[s] (if b then h else 0), rateLimit 1[1/s] degrees
  >       , (arr (\p -> p.heading) >>> highPass 1[s] >>> lowPass 2[s]) pose
  >       , ((proc p -> p.heading) >>> lowPass 1[s]) pose, (slewFrom 0 1[1/s] 1[1/s^2] h).position ] )
  >   where
  >     pose = robotPose i
  >     h = pose.heading
  >     compass = fromMaybe 0 (compassHeading i)
  >     degrees = -h / 1[deg]
  >     command = rateLimit 2[1/s^2] (2[1/s] * angleDiff 0.3 h)
  > FROB
  $ frobc check ways.frob 2>&1 | grep '^warning' | sort | uniq -c
        1 warning[W0315]: `derivative` is applied to an angle that wraps
        1 warning[W0315]: `highPass` is applied to an angle that wraps
        6 warning[W0315]: `lowPass` is applied to an angle that wraps
        1 warning[W0315]: `mean` is applied to an angle that wraps
        1 warning[W0315]: `median` is applied to an angle that wraps
        1 warning[W0315]: `pid2` is applied to an angle that wraps
        1 warning[W0315]: `pidInput` is applied to an angle that wraps
        1 warning[W0315]: `pid` is applied to an angle that wraps
        1 warning[W0315]: `rateLimit` is applied to an angle that wraps
        1 warning[W0315]: `slewFrom` is applied to an angle that wraps
        1 warning[W0315]: `stateVariable` is applied to an angle that wraps
  $ frobc fix --all ways.frob > fixes
  warning[W0315]: `pidInput` is applied to an angle that wraps
    --> ways.frob:14:75
     |
  14 | …s) (0, h), pidWith (pidSettings gains) (pidInput 0 h), pid gains (unwrap (compass + 0.1))
     |                                          ^^^^^^^^   - this angle is between -pi and pi
     |
     = note: when the angle jumps from pi to -pi, `pidInput` sees a rotation of 360 degrees
     = hint: use `angleInput` (module Pid)
  
  warning[W0315]: `rateLimit` is applied to an angle that wraps
    --> ways.frob:18:87
     |
  18 |       , lowPassAngle 1[s] (delayBy 0.5[s] h), lowPassAngle 1[s] (if b then h else 0), rateLimit 1[1/s] degrees
     |                                                                                       ^^^^^^^^^        ------- this angle is between -pi and pi
     |
     = note: when the angle jumps from pi to -pi, `rateLimit` sees a rotation of 360 degrees
     = hint: make the angle continuous with `unwrap` (module Angles)
  
  2 warnings
  $ frobc check ways.frob 2>&1 | grep -e '^warning' -e '-->' -e hint
  warning[W0315]: `pidInput` is applied to an angle that wraps
    --> ways.frob:14:75
     = hint: use `angleInput` (module Pid)
  warning[W0315]: `rateLimit` is applied to an angle that wraps
    --> ways.frob:18:87
     = hint: make the angle continuous with `unwrap` (module Angles)
  $ grep -A 7 '    ( \[' ways.frob
      ( [ pidAngle (pidSettings gains) (0, h), pidWith (pidSettings gains) (pidInput 0 h), pid gains (unwrap (compass + 0.1))
        , angularRate (holdFinite 0 h), command ]
      , [ (stateVariable 2[Hz] 1 (unwrap h)).low, median (recent (unwrap h) :: Array 5 Angle), meanAngle [h, 0.1]
        , lowPassAngle 1[s] (imuHeading 2[s] i), lowPassAngle 1[s] (h + 0.1), lowPass 1[s] (2 * (unwrap h))
        , lowPassAngle 1[s] (delayBy 0.5[s] h), lowPassAngle 1[s] (if b then h else 0), rateLimit 1[1/s] degrees
        , (arr (\p -> p.heading) >>> unwrap >>> highPass 1[s] >>> lowPass 2[s]) pose
        , ((proc p -> p.heading) >>> lowPassAngle 1[s]) pose, (slewFrom 0 1[1/s] 1[1/s^2] (unwrap h)).position ] )
    where
