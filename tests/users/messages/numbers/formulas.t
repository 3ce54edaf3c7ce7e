Formulas and constants whose unit is wrong, and units that Frob does not declare. Every replacement
that a message offers compiles when it is pasted.

The gain lacks its unit; the limit is right, as `setVelTR` shows:

  $ cat > gain.frob <<'FROB'
  > import Control
  > import Robot
  > kP = 0.8
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = limit 0.4[m/s] (kP * (frontSonar i - 0.5[m])))
  > FROB
  $ frobc check gain.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> gain.frob:5:25
    |
  3 | kP = 0.8
    |      --- `kP` is defined as this number, which has no unit
  4 | main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  5 |     v = limit 0.4[m/s] (kP * (frontSonar i - 0.5[m])))
    |         ----- --------  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this is `Float[m]`
    |         |     |
    |         |     because this is `Float[m/s]`
    |         argument 2 of `limit` is `Float[m/s]`
    |
    = hint: give `kP` its unit: `kP = 0.8[1/s]`
  
  1 error
  [1]
  $ sed 's:= 0.8:= 0.8[1/s]:' gain.frob > pasted.frob && frobc check pasted.frob

The product before the number:

  $ cat > least.frob <<'FROB'
  > import Control
  > import Robot
  > kP = 0.8
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = min (kP * (frontSonar i - 0.5[m])) 0.4[m/s])
  > FROB
  $ frobc check least.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> least.frob:5:14
    |
  3 | kP = 0.8
    |      --- `kP` is defined as this number, which has no unit
  4 | main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  5 |     v = min (kP * (frontSonar i - 0.5[m])) 0.4[m/s])
    |              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^  -------- because this is `Float[m/s]`, and `min` needs matching units
    |              |
    |              argument 1 of `min`
    |
    = hint: give `kP` its unit: `kP = 0.8[1/s]`
  
  1 error
  [1]
  $ sed 's:= 0.8:= 0.8[1/s]:' least.frob > pasted.frob && frobc check pasted.frob
  warning[W0306]: `Control` is imported, but nothing from it is used
   --> pasted.frob:1:1
    |
  1 | import Control
    | ^^^^^^^^^^^^^^
    |
    = hint: remove it
  
  1 warning

A limit of the rate of change:

  $ cat > rate.frob <<'FROB'
  > import Control
  > import Robot
  > kP = 0.8
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = rateLimit 0.4[m/s^2] (kP * (frontSonar i - 0.5[m])))
  > FROB
  $ frobc check rate.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> rate.frob:5:31
    |
  3 | kP = 0.8
    |      --- `kP` is defined as this number, which has no unit
  4 | main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  5 |     v = rateLimit 0.4[m/s^2] (kP * (frontSonar i - 0.5[m])))
    |         --------- ----------  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this is `Float[m]`
    |         |         |
    |         |         because this is `Float[m/s^2]`
    |         argument 2 of `rateLimit` is `Float[m/s]`
    |
    = hint: give `kP` its unit: `kP = 0.8[1/s]`
  
  1 error
  [1]
  $ sed 's:= 0.8:= 0.8[1/s]:' rate.frob > pasted.frob && frobc check pasted.frob

A gain in an equation, behind another equation:

  $ cat > equation.frob <<'FROB'
  > import Control
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     kP = 0.8
  >     wanted = kP * (frontSonar i - 0.5[m])
  >     v = deadband 0.05[m/s] wanted)
  > FROB
  $ frobc check equation.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> equation.frob:6:28
    |
  4 |     kP = 0.8
    |          --- `kP` is defined as this number, which has no unit
  5 |     wanted = kP * (frontSonar i - 0.5[m])
  6 |     v = deadband 0.05[m/s] wanted)
    |         -------- --------- ^^^^^^ this is `Float[m]`
    |         |        |
    |         |        because this is `Float[m/s]`
    |         argument 2 of `deadband` is `Float[m/s]`
    |
    = hint: give `kP` its unit: `kP = 0.8[1/s]`
  
  1 error
  [1]
  $ sed 's:= 0.8:= 0.8[1/s]:' equation.frob > pasted.frob && frobc check pasted.frob

A parameter, behind a function that keeps the unit:

  $ cat > parameter.frob <<'FROB'
  > import Control
  > import Robot
  > param kP :: Float = 0.8
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = max 0.05[m/s] (abs (kP * (frontSonar i - 0.5[m]))))
  > FROB
  $ frobc check parameter.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> parameter.frob:5:24
    |
  3 | param kP :: Float = 0.8
    |                     --- `kP` is defined as this number, which has no unit
  4 | main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  5 |     v = max 0.05[m/s] (abs (kP * (frontSonar i - 0.5[m]))))
    |         --- ---------  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this is `Float[m]`
    |         |   |
    |         |   because this is `Float[m/s]`
    |         argument 2 of `max` is `Float[m/s]`
    |
    = hint: give `kP` its unit: `param kP :: Float[1/s] = 0.8[1/s]`
  
  1 error
  [1]
  $ sed 's|kP :: Float = 0.8|kP :: Float[1/s] = 0.8[1/s]|' parameter.frob > pasted.frob && frobc check pasted.frob
  warning[W0306]: `Control` is imported, but nothing from it is used
   --> pasted.frob:1:1
    |
  1 | import Control
    | ^^^^^^^^^^^^^^
    |
    = hint: remove it
  
  1 warning

The value of an event:

  $ cat > held.frob <<'FROB'
  > import Control
  > import Robot
  > kP = 0.8
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = hold 0.1[m/s] (tag (edge (bumped i)) (kP * (frontSonar i - 0.5[m]))))
  > FROB
  $ frobc check held.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> held.frob:5:24
    |
  3 | kP = 0.8
    |      --- `kP` is defined as this number, which has no unit
  4 | main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  5 |     v = hold 0.1[m/s] (tag (edge (bumped i)) (kP * (frontSonar i - 0.5[m]))))
    |         ---- --------  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this is `Event Float[m]`
    |         |    |
    |         |    because this is `Float[m/s]`
    |         argument 2 of `hold` is `Event Float[m/s]`
    |
    = note: expected `Event Float[m/s]`, found `Event Float[m]`
    = hint: give `kP` its unit: `kP = 0.8[1/s]`
  
  1 error
  [1]
  $ sed 's:= 0.8:= 0.8[1/s]:' held.frob > pasted.frob && frobc check pasted.frob
  warning[W0306]: `Control` is imported, but nothing from it is used
   --> pasted.frob:1:1
    |
  1 | import Control
    | ^^^^^^^^^^^^^^
    |
    = hint: remove it
  
  1 warning

A field of a record:

  $ cat > field.frob <<'FROB'
  > import Control
  > import Robot
  > data Gains = Gains { kp :: Float, ki :: Float }
  > gains = Gains { kp = 0.8, ki = 0.1 }
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = limit 0.4[m/s] (gains.kp * (frontSonar i - 0.5[m])))
  > FROB
  $ frobc check field.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> field.frob:6:25
    |
  4 | gains = Gains { kp = 0.8, ki = 0.1 }
    |                      --- `kp` is defined as this number, which has no unit
  5 | main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  6 |     v = limit 0.4[m/s] (gains.kp * (frontSonar i - 0.5[m])))
    |         ----- --------  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this is `Float[m]`
    |         |     |
    |         |     because this is `Float[m/s]`
    |         argument 2 of `limit` is `Float[m/s]`
    |
    = hint: give the field `kp` its unit: `kp = 0.8[1/s]`, and `kp :: Float[1/s]` in the declaration of the record
  
  1 error
  [1]
  $ sed 's:kp = 0.8:kp = 0.8[1/s]:; s:kp \:\: Float:kp \:\: Float[1/s]:' field.frob > pasted.frob && frobc check pasted.frob

A square where its root is needed:

  $ cat > far.frob <<'FROB'
  > far :: Distance -> Distance -> Bool
  > far dx dy = dx * dx + dy * dy > 0.5[m]
  > main :: SF (Distance, Distance) Bool
  > main = proc (x, y) -> far x y
  > FROB
  $ frobc check far.frob
  error[E0320]: the operands of `>` have different units: `m^2` and `m`
   --> far.frob:2:33
    |
  2 | far dx dy = dx * dx + dy * dy > 0.5[m]
    |             -----------------   ^^^^^^ this is `Float[m]`
    |             |
    |             this is `Float[m^2]`
    |
    = hint: for the square root, write `sqrt (dx * dx + dy * dy)`
    = hint: to use the square, write `0.5[m] ^ 2`
  
  1 error
  [1]
  $ sed 's:dx \* dx + dy \* dy:sqrt (&):' far.frob > pasted.frob && frobc check pasted.frob
  $ sed 's:0.5.m.:0.5[m] ^ 2:' far.frob > pasted.frob && frobc check pasted.frob

  $ cat > result.frob <<'FROB'
  > apart :: Distance -> Distance -> Distance
  > apart x y = min 2[m] (x * x + y * y)
  > main :: SF (Distance, Distance) Distance
  > main = proc (x, y) -> apart x y
  > FROB
  $ frobc check result.frob
  error[E0320]: expected the unit `m`, found `m^2`
   --> result.frob:2:23
    |
  2 | apart x y = min 2[m] (x * x + y * y)
    |             --- ----  ^^^^^^^^^^^^^ this is `Float[m^2]`
    |             |   |
    |             |   because this is `Float[m]`
    |             argument 2 of `min` is `Float[m]`
    |
    = hint: for the square root, write `sqrt (x * x + y * y)`
  
  1 error
  [1]
  $ sed 's:(x \* x + y \* y):(sqrt &):' result.frob > pasted.frob && frobc check pasted.frob

  $ cat > cube.frob <<'FROB'
  > large :: Distance -> Bool
  > large x = x * x * x > 0.5[m]
  > main :: SF Distance Bool
  > main = proc x -> large x
  > FROB
  $ frobc check cube.frob
  error[E0320]: the operands of `>` have different units: `m^3` and `m`
   --> cube.frob:2:23
    |
  2 | large x = x * x * x > 0.5[m]
    |           ---------   ^^^^^^ this is `Float[m]`
    |           |
    |           this is `Float[m^3]`
    |
    = hint: to use the cube, write `0.5[m] ^ 3`
  
  1 error
  [1]
  $ sed 's:0.5.m.:0.5[m] ^ 3:' cube.frob > pasted.frob && frobc check pasted.frob

A square root written as a power:

  $ cat > root.frob <<'FROB'
  > safe :: Distance -> Velocity
  > safe d = (2 * 0.5[m/s^2] * d) ^ 0.5
  > main :: SF Distance Velocity
  > main = proc d -> safe d
  > FROB
  $ frobc check root.frob
  error[E0117]: the exponent of `^` must be a literal whole number
   --> root.frob:2:33
    |
  2 | safe d = (2 * 0.5[m/s^2] * d) ^ 0.5
    |                                 ^^^
    |
    = hint: for a square root, write `sqrt (2 * 0.5[m/s^2] * d)`
  
  1 error
  [1]
  $ sed 's:(2.*:sqrt (2 * 0.5[m/s^2] * d):' root.frob > pasted.frob && frobc check pasted.frob

A formula that lacks the square of a variable:

  $ cat > stopping.frob <<'FROB'
  > stopping :: Velocity -> Acceleration -> Distance
  > stopping v a = v / (2 * a)
  > main :: SF Velocity Bool
  > main = proc v -> stopping v 0.5[m/s^2] < 1[m]
  > FROB
  $ frobc check stopping.frob
  error[E0320]: expected the unit `m`, found `s`
   --> stopping.frob:2:16
    |
  1 | stopping :: Velocity -> Acceleration -> Distance
    |             ------------------------------------ the signature of `stopping` requires `Distance` (m)
  2 | stopping v a = v / (2 * a)
    |                ^^^^^^^^^^^ this is `Float[s]`
    |
    = hint: the missing factor `m/s` is the unit of `v`: write `v ^ 2 / (2 * a)` if you meant its square
    = hint: if this is the right result, write the signature as `stopping :: Velocity -> Acceleration -> Float[s]`
  
  1 error
  [1]
  $ sed 's:= v /:= v ^ 2 /:' stopping.frob > pasted.frob && frobc check pasted.frob

  $ cat > circle.frob <<'FROB'
  > pull :: Distance -> AngularVelocity -> Acceleration
  > pull r w = r * w
  > main :: SF (Distance, AngularVelocity) Acceleration
  > main = proc (r, w) -> pull r w
  > FROB
  $ frobc check circle.frob
  error[E0320]: expected the unit `m/s^2`, found `m/s`
   --> circle.frob:2:12
    |
  1 | pull :: Distance -> AngularVelocity -> Acceleration
    |         ------------------------------------------- the signature of `pull` requires `Acceleration` (m/s^2)
  2 | pull r w = r * w
    |            ^^^^^ this is `Float[m/s]`
    |
    = hint: the missing factor `1/s` is the unit of `w`: write `r * w ^ 2` if you meant its square
    = hint: if this is the right result, write the signature as `pull :: Distance -> AngularVelocity -> Float[m/s]`
  
  1 error
  [1]
  $ sed 's:= r \* w:= r * w ^ 2:' circle.frob > pasted.frob && frobc check pasted.frob

A quantity plus its rate of change:

  $ cat > ahead.frob <<'FROB'
  > import Robot
  > main :: SF RobotInput Angle
  > main = proc i -> heading + turnRate i where
  >     heading = (robotPose i).heading
  > FROB
  $ frobc check ahead.frob
  error[E0320]: the operands of `+` have different units: `1` and `1/s`
   --> ahead.frob:3:28
    |
  3 | main = proc i -> heading + turnRate i where
    |                  -------   ^^^^^^^^^^ this is `AngularVelocity` (1/s)
    |                  |
    |                  this is `Angle` (1)
    |
    = hint: `turnRate i` is a rate of change: multiply it by a time, as in `heading + turnRate i * 0.5[s]`, or, for its sum over time, write `heading + integral (turnRate i)`
  
  1 error
  [1]
  $ sed 's:turnRate i:& * 0.5[s]:' ahead.frob > pasted.frob && frobc check pasted.frob
  $ sed 's:turnRate i:integral (&):' ahead.frob > pasted.frob && frobc check pasted.frob

  $ cat > function.frob <<'FROB'
  > ahead :: Distance -> Velocity -> Distance
  > ahead d v = d + v
  > main :: SF (Distance, Velocity) Distance
  > main = proc (d, v) -> ahead d v
  > FROB
  $ frobc check function.frob
  error[E0320]: the operands of `+` have different units: `m` and `m/s`
   --> function.frob:2:17
    |
  2 | ahead d v = d + v
    |             -   ^ this is `Velocity` (m/s)
    |             |
    |             this is `Distance` (m)
    |
    = hint: `v` is a rate of change: multiply it by a time, as in `d + v * 0.5[s]`
  
  1 error
  [1]
  $ sed 's:d + v:d + v * 0.5[s]:' function.frob > pasted.frob && frobc check pasted.frob

A product whose signature has the unit of a factor; the caller agrees with the product:

  $ cat > area.frob <<'FROB'
  > area :: Distance -> Distance -> Distance
  > area long wide = long * wide
  > main :: SF (Distance, Distance) Bool
  > main = proc (a, b) -> area a b > 1[m^2]
  > FROB
  $ frobc check area.frob
  error[E0320]: expected the unit `m`, found `m^2`
   --> area.frob:2:18
    |
  1 | area :: Distance -> Distance -> Distance
    |         -------------------------------- the signature of `area` requires `Distance` (m)
  2 | area long wide = long * wide
    |                  ^^^^^^^^^^^ this is `Float[m^2]`
    |
    = hint: if this is the right result, write the signature as `area :: Distance -> Distance -> Float[m^2]`
    = hint: for the square root, write `sqrt (long * wide)`
  
  1 error
  [1]
  $ sed 's:-> Distance$:-> Float[m^2]:' area.frob > pasted.frob && frobc check pasted.frob

A quotient written as a product:

  $ cat > duration.frob <<'FROB'
  > duration :: Distance -> Velocity -> Time
  > duration d v = d * v
  > main :: SF (Distance, Velocity) Time
  > main = proc (d, v) -> duration d v
  > FROB
  $ frobc check duration.frob
  error[E0320]: expected the unit `s`, found `m^2/s`
   --> duration.frob:2:16
    |
  1 | duration :: Distance -> Velocity -> Time
    |             ---------------------------- the signature of `duration` requires `Time` (s)
  2 | duration d v = d * v
    |                ^^^^^ this is `Float[m^2/s]`
    |
    = hint: write `d / v`, which has the expected unit
  
  1 error
  [1]
  $ sed 's:d \* v:d / v:' duration.frob > pasted.frob && frobc check pasted.frob

One integral too few:

  $ cat > reckon.frob <<'FROB'
  > main :: SF Acceleration Distance
  > main = proc a -> x where
  >     x = integral a
  > FROB
  $ frobc check reckon.frob
  error[E0320]: expected the unit `m`, found `m/s`
   --> reckon.frob:2:18
    |
  1 | main :: SF Acceleration Distance
    |         ------------------------ the signature of `main` requires the output `Distance` (m)
  2 | main = proc a -> x where
    |                  ^ this is `Float[m/s]`
    |
    = hint: for the sum over time, write `integral x`; for a fixed time, `1[s] * x`
    = hint: if this is the right result, write the signature as `main :: SF Acceleration Float[m/s]`
  
  1 error
  [1]
  $ sed 's:-> x where:-> integral x where:' reckon.frob > pasted.frob && frobc check pasted.frob

The signal function with the wrong signature, and its use:

  $ cat > odometer.frob <<'FROB'
  > import Robot
  > odometer :: SF RobotInput Distance
  > odometer = proc i -> integral (velocity i)
  > main :: SF RobotInput Velocity
  > main = odometer
  > FROB
  $ frobc check odometer.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> odometer.frob:5:8
    |
  4 | main :: SF RobotInput Velocity
    |         ---------------------- the signature of `main` requires `SF RobotInput Velocity`
  5 | main = odometer
    |        ^^^^^^^^ this is `SF RobotInput Distance`
    |
    = note: expected `SF RobotInput Velocity`, found `SF RobotInput Distance`
    = hint: if this is the right result, write the signature as `main :: SF RobotInput Distance`
  
  1 error
  [1]
  $ sed 's:^main \:\:.*:main \:\: SF RobotInput Distance:' odometer.frob > pasted.frob && frobc check pasted.frob

A rate of change from the previous value:

  $ cat > change.frob <<'FROB'
  > import Control
  > import Robot
  > main :: SF RobotInput Acceleration
  > main = proc i -> (velocity i - previous (velocity i)) / 50
  > FROB
  $ frobc check change.frob
  error[E0320]: expected the unit `m/s^2`, found `m/s`
   --> change.frob:4:18
    |
  3 | main :: SF RobotInput Acceleration
    |         -------------------------- the signature of `main` requires the output `Acceleration` (m/s^2)
  4 | main = proc i -> (velocity i - previous (velocity i)) / 50
    |                  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this is `Float[m/s]`
    |
    = hint: for the rate of change, write `derivative (velocity i)`, which divides the difference by the length of the step
  
  1 error
  [1]
  $ sed 's:(velocity.*:derivative (velocity i):' change.frob > pasted.frob && frobc check pasted.frob
  warning[W0306]: `Control` is imported, but nothing from it is used
   --> pasted.frob:1:1
    |
  1 | import Control
    | ^^^^^^^^^^^^^^
    |
    = hint: remove it
  
  1 warning

A rate for a time, as an argument:

  $ cat > smooth.frob <<'FROB'
  > import Control
  > import Robot
  > main :: SF RobotInput Distance
  > main = proc i -> lowPass 5[Hz] (sideSonar i)
  > FROB
  $ frobc check smooth.frob
  error[E0320]: expected the unit `s`, found `1/s`
   --> smooth.frob:4:26
    |
  4 | main = proc i -> lowPass 5[Hz] (sideSonar i)
    |                  ------- ^^^^^ this is `Float[1/s]`
    |                  |
    |                  argument 1 of `lowPass` is `Time` (s)
    |
    = hint: this argument must be a time constant: for the cutoff frequency `5[Hz]`, write `(1 / (2 * pi * 5[Hz]))`
  
  1 error
  [1]
  $ sed 's:5.Hz.:(1 / 5[Hz]):' smooth.frob > pasted.frob && frobc check pasted.frob

Gains without any unit:

  $ cat > gains.frob <<'FROB'
  > import Control
  > import Robot
  > gains = Pid { kp = 1.2, ki = 0.1, kd = 0.05, largest = 0.4 }
  > main = reactimateRobot (proc i -> roMake (setVelTR (pid gains (frontSonar i - 0.5[m])) 0))
  > FROB
  $ frobc check gains.frob
  error[E0320]: expected the unit `1/s`, found none
   --> gains.frob:3:30
    |
  3 | gains = Pid { kp = 1.2, ki = 0.1, kd = 0.05, largest = 0.4 }
    |                         --   ^^^ this is `Float`
    |                         |
    |                         the field `ki` is `Float[1/s]`
    |
    = hint: give all numbers in the record their units: for a `Pid[m, m/s]` (u is `m`, v is `m/s`), for example, write `Pid { kp = 1.2[1/s], ki = 0.1[1/s^2], kd = 0.05, largest = 0.4[m/s] }`
  
  1 error
  [1]
  $ sed 's:Pid {.*:Pid { kp = 1.2[1/s], ki = 0.1[1/s^2], kd = 0.05, largest = 0.4[m/s] }:' gains.frob > pasted.frob && frobc check pasted.frob

The signature determines the units:

  $ cat > heading.frob <<'FROB'
  > import Control
  > import Robot
  > gains :: Pid[1, 1/s]
  > gains = Pid { kp = 1.2, ki = 0.1, kd = 0.05, largest = 0.4 }
  > main = reactimateRobot (proc i -> roMake (setVelTR 0 (pid gains (robotPose i).heading)))
  > FROB
  $ frobc check heading.frob
  error[E0320]: expected the unit `1/s`, found none
   --> heading.frob:4:20
    |
  4 | gains = Pid { kp = 1.2, ki = 0.1, kd = 0.05, largest = 0.4 }
    |               --   ^^^ this is `Float`
    |               |
    |               the field `kp` is `Float[1/s]`
    |
    = hint: give all numbers in the record their units: for a `Pid[1, 1/s]` (u is `1`, v is `1/s`), write `Pid { kp = 1.2[1/s], ki = 0.1[1/s^2], kd = 0.05, largest = 0.4[1/s] }`
  
  1 error
  [1]
  $ sed 's:Pid {.*:Pid { kp = 1.2[1/s], ki = 0.1[1/s^2], kd = 0.05, largest = 0.4[1/s] }:' heading.frob > pasted.frob && frobc check pasted.frob
  warning[W0315]: `pid` is applied to an angle that wraps
   --> pasted.frob:5:55
    |
  5 | main = reactimateRobot (proc i -> roMake (setVelTR 0 (pid gains (robotPose i).heading)))
    |                                                       ^^^       --------------------- this angle is between -pi and pi
    |
    = note: when the angle jumps from pi to -pi, `pid` sees a rotation of 360 degrees
    = hint: make the angle continuous with `unwrap` (module Angles)
  
  1 warning

An angle from 0 on:

  $ cat > wrap.frob <<'FROB'
  > wrap :: Angle -> Angle
  > wrap a = a `mod` (2 * pi)
  > main :: SF Angle Angle
  > main = proc a -> wrap a
  > FROB
  $ frobc check wrap.frob
  error[E0312]: expected `Int`, found `Angle` (1)
   --> wrap.frob:2:10
    |
  2 | wrap a = a `mod` (2 * pi)
    |          ^ ----- argument 1 of `mod` is `Int`
    |
    = hint: `mod` is for whole numbers: for an angle between -pi and pi, write `wrapAngle a`, with `import Geometry`; for an angle that is never negative, write `a - (2 * pi) * floorFloat (a / (2 * pi))`
  
  1 error
  [1]
  $ sed 's:= a .*:= a - (2 * pi) * floorFloat (a / (2 * pi)):' wrap.frob > pasted.frob && frobc check pasted.frob

A power of another language:

  $ cat > power.frob <<'FROB'
  > energy :: Float[kg] -> Velocity -> Float[J]
  > energy m v = 0.5 * m * pow v 2
  > main :: SF Velocity Float[J]
  > main = proc v -> energy 9[kg] v
  > FROB
  $ frobc check power.frob
  error[E0205]: unknown name `pow`
   --> power.frob:2:24
    |
  2 | energy m v = 0.5 * m * pow v 2
    |                        ^^^
    |
    = hint: write `v ^ 2`
  
  1 error
  [1]
  $ sed 's:pow v 2:v ^ 2:' power.frob > pasted.frob && frobc check pasted.frob

A state whose parts have different units:

  $ cat > state.frob <<'FROB'
  > predict :: Time -> Array 2 Float -> Array 2 Float
  > predict dt s = [s ! 0 + dt * s ! 1, s ! 1]
  > main :: SF (Array 2 Float) (Array 2 Float)
  > main = proc s -> predict 0.1[s] s
  > FROB
  $ frobc check state.frob
  error[E0320]: the operands of `+` have different units: `1` and `s`
   --> state.frob:2:25
    |
  2 | predict dt s = [s ! 0 + dt * s ! 1, s ! 1]
    |                 -----   ^^^^^^^^^^ this is `Float[s]`
    |                 |
    |                 this is `Float`
    |
    = hint: divide by the unit, `(dt * s ! 1) / 1[s]`; for values with different units, use a record instead of an array
  
  1 error
  [1]
  $ sed 's:dt \* s ! 1:(&) / 1[s]:' state.frob > pasted.frob && frobc check pasted.frob

A text where a number is needed:

  $ cat > text.frob <<'FROB'
  > slow :: Bool -> Velocity
  > slow near = if near then "stop" else 0.3[m/s]
  > main :: SF Bool Velocity
  > main = proc b -> slow b
  > FROB
  $ frobc check text.frob
  error[E0301]: expected `Velocity` (m/s), found `String`
   --> text.frob:2:26
    |
  1 | slow :: Bool -> Velocity
    |         ---------------- the signature of `slow` requires `Velocity` (m/s)
  2 | slow near = if near then "stop" else 0.3[m/s]
    |                          ^^^^^^
    |
    = hint: a string is only a label: write a number, such as `0[m/s]`, in its place
  
  1 error
  [1]
  $ sed 's:"stop":0[m/s]:' text.frob > pasted.frob && frobc check pasted.frob

A tuple that lacks a part, and one with a part too many:

  $ cat > parts.frob <<'FROB'
  > f :: SF (Velocity, Distance, Distance) Velocity
  > f = proc (v, d, e) -> v * (d / e)
  > main :: SF (Velocity, Distance) (Velocity, Velocity)
  > main = proc (v, d) -> (f (d, d), f (v, d, d, True))
  > FROB
  $ frobc check parts.frob
  error[E0301]: expected a tuple with 3 elements, found one with 2
   --> parts.frob:4:26
    |
  4 | main = proc (v, d) -> (f (d, d), f (v, d, d, True))
    |                        - ^^^^^^
    |                        |
    |                        argument 1 of `f` is `(Velocity, Distance, Distance)`
    |
    = hint: the first element, `Velocity` (m/s), is missing
  
  error[E0301]: expected a tuple with 3 elements, found one with 4
   --> parts.frob:4:36
    |
  4 | main = proc (v, d) -> (f (d, d), f (v, d, d, True))
    |                                  - ^^^^^^^^^^^^^^^
    |                                  |
    |                                  argument 1 of `f` is `(Velocity, Distance, Distance)`
    |
    = hint: the fourth element, `Bool`, is one too many: write `(v, d, d)`
  
  2 errors
  [1]
  $ sed 's:f (d, d):f (v, d, d):; s:, True::' parts.frob > pasted.frob && frobc check pasted.frob

Temperatures in degrees:

  $ cat > hot.frob <<'FROB'
  > hot, cold :: Float[K] -> Bool
  > hot t = t > 80[degC]
  > cold t = t < 14[degF]
  > main :: SF Float[K] Bool
  > main = proc t -> hot t || cold t
  > FROB
  $ frobc check hot.frob
  error[E0208]: unknown unit `degC`
   --> hot.frob:2:16
    |
  2 | hot t = t > 80[degC]
    |                ^^^^
    |
    = hint: use kelvin: write `353.15[K]` for this temperature, or `80[K]` for a temperature difference
  
  error[E0208]: unknown unit `degF`
   --> hot.frob:3:17
    |
  3 | cold t = t < 14[degF]
    |                 ^^^^
    |
    = hint: use kelvin: write `263.15[K]` for this temperature, or `7.78[K]` for a temperature difference
  
  2 errors
  [1]
  $ sed 's:80.degC.:353.15[K]:; s:14.degF.:263.15[K]:' hot.frob > pasted.frob && frobc check pasted.frob

Units that the prelude does not declare:

  $ cat > units.frob <<'FROB'
  > fast = 5[mph]
  > low = 300[mV]
  > loop = 2[kHz]
  > steps = 40[ticks]
  > shock :: Acceleration -> Bool
  > shock a = a > 2[G]
  > main :: SF Velocity Bool
  > main = proc v -> v > fast && shock 1[m/s^2]
  > FROB
  $ frobc check units.frob
  error[E0208]: unknown unit `mph`
   --> units.frob:1:10
    |
  1 | fast = 5[mph]
    |          ^^^
    |
    = hint: write `2.2352[m/s]`, or declare the unit on a line of its own: `unit mph = 0.44704 m/s`
  
  error[E0208]: unknown unit `mV`
   --> units.frob:2:11
    |
  2 | low = 300[mV]
    |           ^^
    |
    = hint: write `0.3[V]`, or declare the unit on a line of its own: `unit mV = 0.001 V`
  
  error[E0208]: unknown unit `kHz`
   --> units.frob:3:10
    |
  3 | loop = 2[kHz]
    |          ^^^
    |
    = hint: write `2000[Hz]`, or declare the unit on a line of its own: `unit kHz = 1000 Hz`
  
  error[E0208]: unknown unit `ticks`
   --> units.frob:4:12
    |
  4 | steps = 40[ticks]
    |            ^^^^^
    |
    = hint: write a plain number: `40`
  
  error[E0208]: unknown unit `G`
   --> units.frob:6:17
    |
  6 | shock a = a > 2[G]
    |                 ^
    |
    = hint: write `19.6133[m/s^2]`, or declare the unit on a line of its own: `unit G = 9.80665 m/s^2`
  
  5 errors
  [1]
  $ sed 's:5.mph.:2.2352[m/s]:; s:300.mV.:0.3[V]:; s:2.kHz.:2000[Hz]:; s:40.ticks.:40:; s:2.G.:19.6133[m/s^2]:' units.frob > pasted.frob && frobc check pasted.frob

A declaration of the unit:

  $ cat > miles.frob <<'FROB'
  > fast = 5[mph]
  > main :: SF Velocity Bool
  > main = proc v -> v > fast && v < 9[mph]
  > FROB
  $ frobc check miles.frob
  error[E0208]: unknown unit `mph`
   --> miles.frob:1:10
    |
  1 | fast = 5[mph]
    |          ^^^
  2 | main :: SF Velocity Bool
  3 | main = proc v -> v > fast && v < 9[mph]
    |                                    --- and here
    |
    = hint: write `2.2352[m/s]`, or declare the unit on a line of its own: `unit mph = 0.44704 m/s`
  
  1 error
  [1]
  $ sed '1i unit mph = 0.44704 m/s\n' miles.frob > pasted.frob && frobc check pasted.frob

Multiples of the gravitational acceleration:

  $ cat > bump.frob <<'FROB'
  > main :: SF Acceleration Bool
  > main = proc a -> a > 2[g]
  > FROB
  $ frobc check bump.frob
  error[E0320]: the operands of `>` have different units: `m/s^2` and `kg`
   --> bump.frob:2:22
    |
  2 | main = proc a -> a > 2[g]
    |                  -   ^^^^ this is `Float[kg]`
    |                  |
    |                  this is `Acceleration` (m/s^2)
    |
    = hint: `g` means gram: for a multiple of the gravitational acceleration, write `19.613[m/s^2]`
  
  1 error
  [1]
  $ sed 's:2.g.:19.613[m/s^2]:' bump.frob > pasted.frob && frobc check pasted.frob
