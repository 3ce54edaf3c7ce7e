Units that are missing or wrong.

A turn, a pause, and a unit after a space:

  $ cat > turn_without_unit.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 30))
  > FROB
  $ frobc check turn_without_unit.frob
  error[E0320]: expected the unit `1/s`, found none
   --> turn_without_unit.frob:3:61
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 30))
    |                                           --------          ^^ this is `Float`
    |                                           |
    |                                           argument 2 of `setVelTR` is `AngularVelocity` (1/s)
    |
    = hint: write `30[deg/s]` for degrees per second, or `30[rad/s]` for radians per second
  
  1 error
  [1]
  $ cat > milliseconds.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (do
  >     sleepT 1000 (roMake (setVelTR 0.2[m/s] 0))
  >     sleepT 500 (roMake (setVelTR 0 1[rad/s])))
  > FROB
  $ frobc check milliseconds.frob
  error[E0320]: expected the unit `s`, found none
   --> milliseconds.frob:4:12
    |
  4 |     sleepT 1000 (roMake (setVelTR 0.2[m/s] 0))
    |     ------ ^^^^ this is `Float`
    |     |
    |     argument 1 of `sleepT` is `Time` (s)
    |
    = hint: write `1000[ms]` if these are milliseconds, or `1000[s]` if these are seconds
  
  error[E0320]: expected the unit `s`, found none
   --> milliseconds.frob:5:12
    |
  5 |     sleepT 500 (roMake (setVelTR 0 1[rad/s])))
    |     ------ ^^^ this is `Float`
    |     |
    |     argument 1 of `sleepT` is `Time` (s)
    |
    = hint: write `500[ms]` if these are milliseconds, or `500[s]` if these are seconds
  
  2 errors
  [1]
  $ cat > unit_after_a_space.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.3 [m/s] 0))
  > FROB
  $ frobc check unit_after_a_space.frob
  error[E0205]: there is a space between this unit and its number
   --> unit_after_a_space.frob:3:56
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR 0.3 [m/s] 0))
    |                                                        ^^^^^
    |
    = hint: write the unit in square brackets directly after the number: `0.3[m/s]`
  
  1 error
  [1]

Conversions from one quantity to another:

  $ cat > speed_from_distance.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (frontSonar i - 0.5[m]) 0))
  > FROB
  $ frobc check speed_from_distance.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> speed_from_distance.frob:3:53
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR (frontSonar i - 0.5[m]) 0))
    |                                           --------  ^^^^^^^^^^^^^^^^^^^^^ this is `Float[m]`
    |                                           |
    |                                           argument 1 of `setVelTR` is `Velocity` (m/s)
    |
    = hint: multiply by a gain, as in `0.5[1/s] * (frontSonar i - 0.5[m])`, or, for the rate of change, write `derivative (frontSonar i - 0.5[m])`
  
  1 error
  [1]
  $ cat > distance_plus_speed.frob <<'FROB'
  > main :: SF (Distance, Velocity) Distance
  > main = proc (x, v) -> x + v * 2
  > FROB
  $ frobc check distance_plus_speed.frob
  error[E0320]: the operands of `+` have different units: `m` and `m/s`
   --> distance_plus_speed.frob:2:27
    |
  2 | main = proc (x, v) -> x + v * 2
    |                       -   ^^^^^ this is `Float[m/s]`
    |                       |
    |                       this is `Distance` (m)
    |
    = hint: multiply by a time, as in `1[s] * (v * 2)`, or, for the sum over time, write `integral (v * 2)`
  
  1 error
  [1]
  $ cat > squared_distance.frob <<'FROB'
  > import Geometry
  > 
  > main :: SF Point2 Distance
  > main = proc p -> p.x ^ 2 + p.y ^ 2
  > FROB
  $ frobc check squared_distance.frob
  error[E0320]: expected the unit `m`, found `m^2`
   --> squared_distance.frob:4:18
    |
  3 | main :: SF Point2 Distance
    |         ------------------ the signature of `main` requires the output `Distance` (m)
  4 | main = proc p -> p.x ^ 2 + p.y ^ 2
    |                  ^^^^^^^^^^^^^^^^^ this is `Float[m^2]`
    |
    = hint: for the square root, write `sqrt (p.x ^ 2 + p.y ^ 2)`
    = hint: if this is the right result, write the signature as `main :: SF Point2 Float[m^2]`
  
  1 error
  [1]
  $ cat > double_for_velocity.frob <<'FROB'
  > slow :: Double -> Double
  > slow v = min v 0.2
  > 
  > main :: SF Velocity Velocity
  > main = arr slow
  > FROB
  $ frobc check double_for_velocity.frob
  error[E0320]: expected the unit `m/s`, found none
   --> double_for_velocity.frob:5:8
    |
  4 | main :: SF Velocity Velocity
    |         -------------------- the signature of `main` requires `SF Velocity Velocity`
  5 | main = arr slow
    |        ^^^^^^^^ this is `SF Double Double`
    |
    = note: expected `SF Velocity Velocity`, found `SF Double Double`
    = hint: use `Float[m/s]` for this unit; without brackets, `Float` and `Double` have no unit
  
  1 error
  [1]

The gains of a controller depend on each other, so a wrong unit has one message:

  $ cat > pid_of_three_numbers.frob <<'FROB'
  > import Control
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = pid 1 0.1 0.01 (frontSonar i - 0.5[m]))
  > FROB
  $ frobc check pid_of_three_numbers.frob
  error[E0301]: expected `Pid[u, v]`, found a number
   --> pid_of_three_numbers.frob:5:13
    |
  5 |     v = pid 1 0.1 0.01 (frontSonar i - 0.5[m]))
    |         --- ^
    |         |
    |         argument 1 of `pid` is `Pid[u, v]`
    |
    = hint: `pid` takes a single record, not separate numbers: write `pid (Pid { kp = 1, ki = 0.1, kd = 0.01, largest = … }) (frontSonar i - 0.5[m])`
  
  1 error
  [1]
  $ cat > pid_gains_without_units.frob <<'FROB'
  > import Control
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = pid gains (frontSonar i - 0.5[m])
  >     gains = Pid { kp = 0.8, ki = 0.1, kd = 0.05, largest = 0.3[m/s] })
  > FROB
  $ frobc check pid_gains_without_units.frob
  error[E0320]: expected the unit `1/s`, found none
   --> pid_gains_without_units.frob:6:34
    |
  6 |     gains = Pid { kp = 0.8, ki = 0.1, kd = 0.05, largest = 0.3[m/s] })
    |                             --   ^^^ this is `Float`
    |                             |
    |                             the field `ki` is `Float[1/s]`
    |
    = hint: give all numbers in the record their units: for a `Pid[m, m/s]` (u is `m`, v is `m/s`), for example, write `Pid { kp = 0.8[1/s], ki = 0.1[1/s^2], kd = 0.05, largest = 0.3[m/s] }`
  
  1 error
  [1]
  $ cat > pid_gain_of_wrong_unit.frob <<'FROB'
  > import Control
  > import Robot
  > 
  > gains = Pid { kp = 0.8[1/s], ki = 0.1[1/s], kd = 0.05, largest = 0.3[m/s] }
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (pid gains (frontSonar i - 0.5[m])) 0))
  > FROB
  $ frobc check pid_gain_of_wrong_unit.frob
  error[E0320]: expected the unit `1/s^2`, found `1/s`
   --> pid_gain_of_wrong_unit.frob:4:35
    |
  4 | gains = Pid { kp = 0.8[1/s], ki = 0.1[1/s], kd = 0.05, largest = 0.3[m/s] }
    |                              --   ^^^^^^^^ this is `Float[1/s]`
    |                              |
    |                              the field `ki` is `Float[1/s^2]`
    |
    = note: in a `Pid`, the units depend on each other: `kp` has `v/u`, `ki` has `v/u/s`, `kd` has `v s/u`, `largest` has `v`
    = hint: write `0.1[1/s^2]` if you meant that unit
  
  1 error
  [1]

Types with the same name, and a local function of one type:

  $ cat > two_modules_T.frob <<'FROB'
  > import qualified Geometry as G
  > import Robot
  > 
  > data Pose = Pose { position :: G.Point2, heading :: Angle }
  > 
  > main :: SF RobotInput Pose
  > main = proc i -> robotPose i
  > FROB
  $ frobc check two_modules_T.frob
  error[E0301]: expected `Main.Pose`, found `Geometry.Pose`
   --> two_modules_T.frob:7:18
    |
  6 | main :: SF RobotInput Pose
    |         ------------------ the signature of `main` requires the output `Main.Pose`
  7 | main = proc i -> robotPose i
    |                  ^^^^^^^^^^^
    |
    = hint: two types have the name `Pose`: use the same one in both places, or convert the value
  
  1 error
  [1]
  $ cat > local_at_two_types.frob <<'FROB'
  > main :: SF (Float, Velocity) (Float, Velocity)
  > main = proc (x, v) -> (twice x, twice v) where
  >     twice a = a + a
  > FROB
  $ frobc check local_at_two_types.frob
  error[E0320]: expected no unit, found `m/s`
   --> local_at_two_types.frob:2:39
    |
  2 | main = proc (x, v) -> (twice x, twice v) where
    |                        -----    ----- ^ this is `Velocity` (m/s)
    |                        |        |
    |                        |        argument 1 of `twice` is `Float`
    |                        because of this use of `twice`
    |
    = hint: a local function without a signature has only one type: give `twice` a signature with a variable, as in `twice :: Float[u] -> …`
  
  1 error
  [1]
