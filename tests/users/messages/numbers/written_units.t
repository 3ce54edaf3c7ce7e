Units that are written, but wrong. Every replacement that a message offers compiles when it is pasted.

A superfluous factor:

  $ cat > length.frob <<'FROB'
  > import Geometry
  > fromHome :: Pose -> Distance
  > fromHome p = sqrt (p.position.x ^ 2 + p.position.y ^ 2) * 1[m]
  > FROB
  $ frobc check length.frob
  error[E0320]: expected the unit `m`, found `m^2`
   --> length.frob:3:14
    |
  2 | fromHome :: Pose -> Distance
    |             ---------------- the signature of `fromHome` requires `Distance` (m)
  3 | fromHome p = sqrt (p.position.x ^ 2 + p.position.y ^ 2) * 1[m]
    |              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this is `Float[m^2]`
    |
    = hint: remove `* 1[m]`: `sqrt (p.position.x ^ 2 + p.position.y ^ 2)` is already in `m`
  
  1 error
  [1]
  $ sed 's: \* 1\[m\]::' length.frob > pasted.frob && frobc check pasted.frob

  $ cat > quotient.frob <<'FROB'
  > far :: Distance -> Bool
  > far d = d / 1[m] > 2[m]
  > FROB
  $ frobc check quotient.frob
  error[E0320]: the operands of `>` have different units: `1` and `m`
   --> quotient.frob:2:20
    |
  2 | far d = d / 1[m] > 2[m]
    |         --------   ^^^^ this is `Float[m]`
    |         |
    |         this is `Float`
    |
    = hint: remove `/ 1[m]`: `d` is already in `m`
  
  1 error
  [1]
  $ sed 's: / 1\[m\]::' quotient.frob > pasted.frob && frobc check pasted.frob

A factor that also converts the number stays:

  $ cat > scaled.frob <<'FROB'
  > f :: Distance -> Distance
  > f x = x * 1[km]
  > FROB
  $ frobc check scaled.frob
  error[E0320]: expected the unit `m`, found `m^2`
   --> scaled.frob:2:7
    |
  1 | f :: Distance -> Distance
    |      -------------------- the signature of `f` requires `Distance` (m)
  2 | f x = x * 1[km]
    |       ^^^^^^^^^ this is `Float[m^2]`
    |
    = hint: write `sqrt (x * 1[km])`, which has the expected unit
    = hint: if this is the right result, write the signature as `f :: Distance -> Float[m^2]`
  
  1 error
  [1]

A constant with the wrong unit, reported where it is defined:

  $ cat > turn.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.3[m/s] omega)) where
  >     omega = 0.5[m/s]
  > FROB
  $ frobc check turn.frob
  error[E0320]: expected the unit `1/s`, found `m/s`
   --> turn.frob:2:61
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR 0.3[m/s] omega)) where
    |                                           --------          ^^^^^ this is `Float[m/s]`
    |                                           |
    |                                           argument 2 of `setVelTR` is `AngularVelocity` (1/s)
  3 |     omega = 0.5[m/s]
    |             -------- `omega` is defined as this number
    |
    = hint: write `0.5[rad/s]` if that is the right unit
  
  1 error
  [1]
  $ sed 's:0.5\[m/s\]:0.5[rad/s]:' turn.frob > pasted.frob && frobc check pasted.frob
  warning[W0305]: `i` is never used
   --> pasted.frob:2:30
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR 0.3[m/s] omega)) where
    |                              ^
    |
    = hint: replace it with `_` or `_i`
  
  1 warning

  $ cat > acceleration.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc _ -> roMake (setVelTR v 0) where
  >     v = 0.2[m/s^2])
  > FROB
  $ frobc check acceleration.frob
  error[E0320]: expected the unit `m/s`, found `m/s^2`
   --> acceleration.frob:2:52
    |
  2 | main = reactimateRobot (proc _ -> roMake (setVelTR v 0) where
    |                                           -------- ^ this is `Float[m/s^2]`
    |                                           |
    |                                           argument 1 of `setVelTR` is `Velocity` (m/s)
  3 |     v = 0.2[m/s^2])
    |         ---------- `v` is defined as this number
    |
    = hint: write `0.2[m/s]` if that is the right unit
    = hint: multiply by a time, as in `1[s] * v`, or, for the sum over time, write `integral v`
  
  1 error
  [1]
  $ sed 's:0.2\[m/s^2\]:0.2[m/s]:' acceleration.frob > pasted.frob && frobc check pasted.frob
  $ sed 's:setVelTR v:setVelTR (integral v):' acceleration.frob > pasted.frob && frobc check pasted.frob

A parameter whose type in the signature has the wrong unit:

  $ cat > parameter.frob <<'FROB'
  > import Robot
  > turn :: Angle -> SF RobotInput RobotOutput
  > turn omega = proc _ -> roMake (setVelTR 0 omega)
  > main = reactimateRobot (turn 0.8)
  > FROB
  $ frobc check parameter.frob
  error[E0320]: expected the unit `1/s`, found none
   --> parameter.frob:3:43
    |
  2 | turn :: Angle -> SF RobotInput RobotOutput
    |         ----- the signature gives `omega` this type
  3 | turn omega = proc _ -> roMake (setVelTR 0 omega)
    |                                --------   ^^^^^ this is `Angle` (1)
    |                                |
    |                                argument 2 of `setVelTR` is `AngularVelocity` (1/s)
    |
    = hint: if `omega` is of type `AngularVelocity`, write the signature as `turn :: AngularVelocity -> SF RobotInput RobotOutput`
    = hint: multiply the plain number by a unit or a gain in `1/s`, as in `1[1/s] * omega`
  
  1 error
  [1]
  $ sed -e 's:turn \:\: Angle:turn \:\: AngularVelocity:' -e 's:0.8:0.8[rad/s]:' parameter.frob > pasted.frob && frobc check pasted.frob

A gain with the wrong unit, next to a gain for the rate:

  $ cat > gains.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] omega) where
  >     e     = sideSonar i - 0.4[m]
  >     omega = 4[rad/(m s)] * e + 2[rad/(m s)] * derivative e)
  > FROB
  $ frobc check gains.frob
  error[E0320]: the operands of `+` have different units: `1/s` and `1/s^2`
   --> gains.frob:4:32
    |
  4 |     omega = 4[rad/(m s)] * e + 2[rad/(m s)] * derivative e)
    |             ----------------   ^^^^^^^^^^^^^^^^^^^^^^^^^^^ this is `Float[1/s^2]`
    |             |
    |             this is `Float[1/s]`
    |
    = hint: if the gain `2[rad/(m s)]` should have a different unit, write `2[rad/m]`
  
  1 error
  [1]
  $ sed 's:2\[rad/(m s)\]:2[rad/m]:' gains.frob > pasted.frob && frobc check pasted.frob

  $ cat > named_gain.frob <<'FROB'
  > import Robot
  > kD = 2[rad/(m s)]
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] omega) where
  >     e     = sideSonar i - 0.4[m]
  >     omega = 4[rad/(m s)] * e + kD * derivative e)
  > FROB
  $ frobc check named_gain.frob
  error[E0320]: the operands of `+` have different units: `1/s` and `1/s^2`
   --> named_gain.frob:5:32
    |
  2 | kD = 2[rad/(m s)]
    |      ------------ `kD` is defined as this number
  ...
  5 |     omega = 4[rad/(m s)] * e + kD * derivative e)
    |             ----------------   ^^^^^^^^^^^^^^^^^ this is `Float[1/s^2]`
    |             |
    |             this is `Float[1/s]`
    |
    = hint: if the gain `kD` should have a different unit, write `kD = 2[rad/m]`
  
  1 error
  [1]
  $ sed 's:kD = 2\[rad/(m s)\]:kD = 2[rad/m]:' named_gain.frob > pasted.frob && frobc check pasted.frob

A square in a sum of squares:

  $ cat > squares.frob <<'FROB'
  > f :: Distance -> Distance -> Distance
  > f x y = sqrt (x ^ 2 + y)
  > FROB
  $ frobc check squares.frob
  error[E0320]: the operands of `+` have different units: `m^2` and `m`
   --> squares.frob:2:23
    |
  2 | f x y = sqrt (x ^ 2 + y)
    |               -----   ^ this is `Distance` (m)
    |               |
    |               this is `Float[m^2]`
    |
    = hint: to use the square, write `y ^ 2`
  
  1 error
  [1]
  $ sed 's:+ y:+ y ^ 2:' squares.frob > pasted.frob && frobc check pasted.frob

A factor without a unit, in another equation:

  $ cat > factor.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = 0.5 * (frontSonar i - 0.4[m]))
  > FROB
  $ frobc check factor.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> factor.frob:2:52
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
    |                                           -------- ^ this is `Float[m]`
    |                                           |
    |                                           argument 1 of `setVelTR` is `Velocity` (m/s)
  3 |     v = 0.5 * (frontSonar i - 0.4[m]))
    |         --- this factor has no unit
    |
    = hint: if the factor `0.5` has a unit, write it: `0.5[1/s]`
  
  1 error
  [1]
  $ sed 's:0.5:0.5[1/s]:' factor.frob > pasted.frob && frobc check pasted.frob

A cutoff frequency for a time constant:

  $ cat > cutoff.frob <<'FROB'
  > import Control
  > f :: SF Distance Distance
  > f = proc d -> lowPass 5[Hz] d
  > FROB
  $ frobc check cutoff.frob
  error[E0320]: expected the unit `s`, found `1/s`
   --> cutoff.frob:3:23
    |
  3 | f = proc d -> lowPass 5[Hz] d
    |               ------- ^^^^^ this is `Float[1/s]`
    |               |
    |               argument 1 of `lowPass` is `Time` (s)
    |
    = hint: this argument must be a time constant: for the cutoff frequency `5[Hz]`, write `(1 / (2 * pi * 5[Hz]))`
  
  1 error
  [1]
  $ sed 's:5\[Hz\]:(1 / (2 * pi * 5[Hz])):' cutoff.frob > pasted.frob && frobc check pasted.frob

The settings of a function come before its signal:

  $ cat > filter.frob <<'FROB'
  > import Control
  > f :: SF Distance Distance
  > f = proc d -> lowPass 0.5 d
  > FROB
  $ frobc check filter.frob
  error[E0320]: expected the unit `s`, found none
   --> filter.frob:3:23
    |
  3 | f = proc d -> lowPass 0.5 d
    |               ------- ^^^ this is `Float`
    |               |
    |               argument 1 of `lowPass` is `Time` (s)
    |
    = hint: write `0.5[s]` if that is the right unit
  
  1 error
  [1]

  $ cat > filter_last.frob <<'FROB'
  > import Control
  > f :: SF Distance Distance
  > f = proc d -> lowPass d 0.5
  > FROB
  $ frobc check filter_last.frob
  error[E0320]: the arguments of `lowPass` are in the wrong order
   --> filter_last.frob:3:15
    |
  3 | f = proc d -> lowPass d 0.5
    |               ^^^^^^^^^^^^^
    |
    = hint: write `lowPass 0.5[s] d`
  
  1 error
  [1]
  $ sed 's:lowPass d 0.5:lowPass 0.5[s] d:' filter_last.frob > pasted.frob && frobc check pasted.frob

  $ cat > clamped.frob <<'FROB'
  > import Control
  > f :: SF Velocity Velocity
  > f = proc v -> clamp v (-0.2) 0.4
  > FROB
  $ frobc check clamped.frob
  error[E0320]: the arguments of `clamp` are in the wrong order
   --> clamped.frob:3:15
    |
  3 | f = proc v -> clamp v (-0.2) 0.4
    |               ^^^^^^^^^^^^^^^^^^
    |
    = hint: write `clamp (-0.2[m/s]) 0.4[m/s] v`
  
  1 error
  [1]
  $ sed 's:clamp v (-0.2) 0.4:clamp (-0.2[m/s]) 0.4[m/s] v:' clamped.frob > pasted.frob && frobc check pasted.frob

  $ cat > rate.frob <<'FROB'
  > import Control
  > f :: SF Velocity Velocity
  > f = proc v -> rateLimit v 0.5
  > FROB
  $ frobc check rate.frob
  error[E0320]: the arguments of `rateLimit` are in the wrong order
   --> rate.frob:3:15
    |
  3 | f = proc v -> rateLimit v 0.5
    |               ^^^^^^^^^^^^^^^
    |
    = hint: write `rateLimit 0.5[m/s^2] v`
  
  1 error
  [1]
  $ sed 's:rateLimit v 0.5:rateLimit 0.5[m/s^2] v:' rate.frob > pasted.frob && frobc check pasted.frob

Two limits for `limit`:

  $ cat > limits.frob <<'FROB'
  > import Control
  > f :: SF Velocity Velocity
  > f = proc v -> limit (-0.2[m/s]) 0.4[m/s] (v - 0.1[m/s])
  > FROB
  $ frobc check limits.frob
  error[E0302]: `limit` takes 2 arguments, but is applied to more
   --> limits.frob:3:43
    |
  3 | f = proc v -> limit (-0.2[m/s]) 0.4[m/s] (v - 0.1[m/s])
    |               -----                       ^^^^^^^^^^^^ one too many
    |               |
    |               with 2 arguments, its result is `Float[m/s]`
    |
    = hint: `limit` takes one limit for both directions; for two limits, write `clamp (-0.2[m/s]) 0.4[m/s] (v - 0.1[m/s])`
  
  1 error
  [1]
  $ sed 's:limit (:clamp (:' limits.frob > pasted.frob && frobc check pasted.frob

Quantities that Frob has no units for:

  $ cat > others.frob <<'FROB'
  > bright :: Float -> Bool
  > bright x = x > 300[lux] || x > 60[dB] || x > 4[pixels]
  > FROB
  $ frobc check others.frob
  error[E0208]: unknown unit `lux`
   --> others.frob:2:20
    |
  2 | bright x = x > 300[lux] || x > 60[dB] || x > 4[pixels]
    |                    ^^^
    |
    = hint: declare it on a line of its own, above the definitions: `unit lux`
  
  error[E0208]: unknown unit `dB`
   --> others.frob:2:35
    |
  2 | bright x = x > 300[lux] || x > 60[dB] || x > 4[pixels]
    |                                   ^^
    |
    = hint: write a plain number: `60`
  
  error[E0208]: unknown unit `pixels`
   --> others.frob:2:48
    |
  2 | bright x = x > 300[lux] || x > 60[dB] || x > 4[pixels]
    |                                                ^^^^^^
    |
    = hint: did you mean `px`?
  
  3 errors
  [1]

Numbers of a knob:

  $ cat > knob.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = knob "speed" 0 1 0.5 i)
  > FROB
  $ frobc check knob.frob
  error[E0320]: expected the unit `m/s`, found none
   --> knob.frob:2:52
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
    |                                           -------- ^ this is `Float`
    |                                           |
    |                                           argument 1 of `setVelTR` is `Velocity` (m/s)
  3 |     v = knob "speed" 0 1 0.5 i)
    |         ---------------------- this defines `v`
    |
    = hint: give the numbers their unit: `knob "speed" 0 1[m/s] 0.5[m/s] i`
  
  1 error
  [1]
  $ sed 's:0 1 0.5 i:0 1[m/s] 0.5[m/s] i:' knob.frob > pasted.frob && frobc check pasted.frob

Too few elements:

  $ cat > elements.frob <<'FROB'
  > weights :: Array 4 Float
  > weights = [0.5, 0.3, 0.1]
  > FROB
  $ frobc check elements.frob
  error[E0301]: expected `Array 4 Float`, found `Array 3 Float`
   --> elements.frob:2:11
    |
  1 | weights :: Array 4 Float
    |            ------------- the signature of `weights` requires `Array 4 Float`
  2 | weights = [0.5, 0.3, 0.1]
    |           ^^^^^^^^^^^^^^^
    |
    = hint: add one element, or write `Array 3 Float` in the type
  
  1 error
  [1]
  $ sed 's:0.1]:0.1, 0.1]:' elements.frob > pasted.frob && frobc check pasted.frob

A signature that lacks the type of a parameter:

  $ cat > lacking.frob <<'FROB'
  > import Robot
  > stopBefore :: SF RobotInput RobotOutput
  > stopBefore d = proc i -> roMake (setVelTR v 0) where
  >     v = min 0.3[m/s] (1[1/s] * (frontSonar i - d))
  > main = reactimateRobot (stopBefore 0.4[m])
  > FROB
  $ frobc check lacking.frob
  error[E0302]: the signature of `stopBefore` lacks the type of `d`
   --> lacking.frob:3:12
    |
  2 | stopBefore :: SF RobotInput RobotOutput
    |               ------------------------- the signature of `stopBefore` requires `SF RobotInput RobotOutput`
  3 | stopBefore d = proc i -> roMake (setVelTR v 0) where
    |            ^
    |
    = hint: write `stopBefore :: Float[m] -> SF RobotInput RobotOutput`
  
  1 error
  [1]
  $ sed 's:stopBefore \:\::stopBefore \:\: Float[m] ->:' lacking.frob > pasted.frob && frobc check pasted.frob

A speed and a turn rate for an output:

  $ cat > pair.frob <<'FROB'
  > import Robot
  > drive :: SF RobotInput RobotOutput
  > drive = proc i -> (min 0.3[m/s] (0.5[1/s] * frontSonar i), 0.2[rad/s])
  > main = reactimateRobot drive
  > FROB
  $ frobc check pair.frob
  error[E0301]: expected `RobotOutput`, found `(Float[m/s], Float[1/s])`
   --> pair.frob:3:19
    |
  2 | drive :: SF RobotInput RobotOutput
    |          ------------------------- the signature of `drive` requires the output `RobotOutput`
  3 | drive = proc i -> (min 0.3[m/s] (0.5[1/s] * frontSonar i), 0.2[rad/s])
    |                   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: write `roMake (setVelTR (min 0.3[m/s] (0.5[1/s] * frontSonar i)) 0.2[rad/s])` for a robot's output with this speed and turn rate
  
  1 error
  [1]
  $ sed 's:(min \(.*\), 0.2.*:roMake (setVelTR (min \1) 0.2[rad/s]):' pair.frob > pasted.frob && frobc check pasted.frob

A gain without a unit, for an angle:

  $ cat > heading.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR 0.2[m/s] omega) where
  >     omega = 0.5 * (robotPose i).heading
  > main = reactimateRobot drive
  > FROB
  $ frobc check heading.frob
  error[E0320]: expected the unit `1/s`, found none
   --> heading.frob:2:45
    |
  2 | drive = proc i -> roMake (setVelTR 0.2[m/s] omega) where
    |                           --------          ^^^^^ this is `Float`
    |                           |
    |                           argument 2 of `setVelTR` is `AngularVelocity` (1/s)
  3 |     omega = 0.5 * (robotPose i).heading
    |             --- this factor has no unit
    |
    = hint: if the factor `0.5` has a unit, write it: `0.5[1/s]`
  
  1 error
  [1]
  $ sed 's:0.5 \*:0.5[1/s] *:' heading.frob > pasted.frob && frobc check pasted.frob

A scale without a unit:

  $ cat > ticks.frob <<'FROB'
  > toMeters :: Int -> Distance
  > toMeters n = toFloat n * 0.01
  > FROB
  $ frobc check ticks.frob
  error[E0320]: expected the unit `m`, found none
   --> ticks.frob:2:14
    |
  1 | toMeters :: Int -> Distance
    |             --------------- the signature of `toMeters` requires `Distance` (m)
  2 | toMeters n = toFloat n * 0.01
    |              ^^^^^^^^^^^^^^^^ this is `Float`
    |
    = hint: if the factor `0.01` has a unit, write it: `0.01[m]`
  
  1 error
  [1]
  $ sed 's:0.01:0.01[m]:' ticks.frob > pasted.frob && frobc check pasted.frob

A product in place of a quotient, with a constant:

  $ cat > wheel.frob <<'FROB'
  > radius = 0.05[m]
  > wheel :: Velocity -> AngularVelocity
  > wheel v = v * radius
  > FROB
  $ frobc check wheel.frob
  error[E0320]: expected the unit `1/s`, found `m^2/s`
   --> wheel.frob:3:11
    |
  2 | wheel :: Velocity -> AngularVelocity
    |          --------------------------- the signature of `wheel` requires `AngularVelocity` (1/s)
  3 | wheel v = v * radius
    |           ^^^^^^^^^^ this is `Float[m^2/s]`
    |
    = hint: write `v / radius`, which has the expected unit
  
  1 error
  [1]
  $ sed 's:v \* radius:v / radius:' wheel.frob > pasted.frob && frobc check pasted.frob

Degrees in a type:

  $ cat > degrees.frob <<'FROB'
  > threshold :: Float[deg]
  > threshold = 10[deg]
  > FROB
  $ frobc check degrees.frob
  error[E0321]: a type cannot contain a scaled unit, because values are stored in base units
   --> degrees.frob:1:20
    |
  1 | threshold :: Float[deg]
    |                    ^^^
    |
    = hint: write the type `Angle`, or the unit `1`; use scaled units only after literals
  
  1 error
  [1]
  $ sed 's:Float.deg.:Angle:' degrees.frob > pasted.frob && frobc check pasted.frob

A branch without a unit:

  $ cat > branch.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR v 0) where
  >     v = case bumped i of
  >         True -> 0
  >         False -> 0.3
  > main = reactimateRobot drive
  > FROB
  $ frobc check branch.frob
  error[E0320]: expected the unit `m/s`, found none
   --> branch.frob:2:36
    |
  2 | drive = proc i -> roMake (setVelTR v 0) where
    |                           -------- ^ this is `Float`
    |                           |
    |                           argument 1 of `setVelTR` is `Velocity` (m/s)
  ...
  5 |         False -> 0.3
    |                  --- `v` is defined as this number
    |
    = hint: write `0.3[m/s]` if that is the right unit
  
  1 error
  [1]
  $ sed 's:-> 0.3:-> 0.3[m/s]:' branch.frob > pasted.frob && frobc check pasted.frob

`map` for a single value:

  $ cat > single.frob <<'FROB'
  > f :: Distance -> Distance
  > f d = map (\x -> x * 2) d
  > FROB
  $ frobc check single.frob
  error[E0301]: expected `Array m n[u]`, found `Distance` (m)
   --> single.frob:2:25
    |
  2 | f d = map (\x -> x * 2) d
    |       ---               ^
    |       |
    |       argument 2 of `map` is `Array m n[u]`
    |
    = hint: `map` is for arrays: apply the function directly, as in `(\x -> x * 2) d`
  
  1 error
  [1]
  $ sed 's:map ::' single.frob > pasted.frob && frobc check pasted.frob
