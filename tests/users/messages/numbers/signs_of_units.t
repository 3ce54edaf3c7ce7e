Units in other notations.

A power without `^`, on a number and in a type:

  $ cat > power.frob <<'FROB'
  > import Robot
  > a :: Float[m/s2]
  > a = 9.81[m/s2]
  > main :: SF Float[m/s2] Velocity
  > main = integral
  > FROB
  $ frobc check power.frob
  error[E0208]: unknown unit `s2`
   --> power.frob:3:12
    |
  3 | a = 9.81[m/s2]
    |            ^^
    |
    = hint: write the power with `^`: `s^2`
  
  1 error
  [1]

A degree sign, percent, and a point between units:

  $ cat > degree.frob <<'FROB'
  > import Robot
  > quarter :: Angle
  > quarter = 90°
  > main = reactimateRobot (proc i -> roMake (setVelTR 0 1[rad/s]))
  > FROB
  $ frobc check degree.frob
  error[E0103]: unexpected character `°`
   --> degree.frob:3:13
    |
  3 | quarter = 90°
    |             ^
    |
    = hint: write degrees as a unit: `90[deg]`
  
  1 error
  [1]

  $ cat > percent.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR (50[%] * 0.4[m/s]) 0))
  > FROB
  $ frobc check percent.frob
  error[E0103]: unexpected character `%`
   --> percent.frob:2:56
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR (50[%] * 0.4[m/s]) 0))
    |                                                        ^
    |
    = hint: percent is not a unit: write `0.5`
  
  1 error
  [1]

  $ cat > point.frob <<'FROB'
  > import Robot
  > inertia :: Float[kg.m^2]
  > inertia = 0.2[kg m^2]
  > main = reactimateRobot (proc i -> roMake (setVelTR 0 1[rad/s]))
  > FROB
  $ frobc check point.frob
  error[E0110]: expected `^`, another factor of the unit, or the end of the unit, found `.m`
   --> point.frob:2:20
    |
  2 | inertia :: Float[kg.m^2]
    |                    ^^
    |
    = hint: multiply units with a space or `*`, as in `kg m^2`
  
  1 error
  [1]

A choice between angles, where an angular velocity is expected:

  $ cat > chosen.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] w) where
  >     w = if frontSonar i < 0.5[m] then 45[deg] else 0)
  > FROB
  $ frobc check chosen.frob
  error[E0320]: expected the unit `1/s`, found none
   --> chosen.frob:2:61
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] w) where
    |                                           --------          ^ this is `Float`
    |                                           |
    |                                           argument 2 of `setVelTR` is `AngularVelocity` (1/s)
  3 |     w = if frontSonar i < 0.5[m] then 45[deg] else 0)
    |                                       ------- `w` is defined as this number
    |
    = hint: write `45[deg/s]` if this is the turn rate
  
  1 error
  [1]
