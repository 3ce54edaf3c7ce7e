Results whose unit is not the expected one.

The limits of a knob determine its unit:

  $ cat > knob.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (knob "speed" 0 0.5 0.2 i) 0))
  > FROB
  $ frobc check knob.frob
  error[E0320]: expected the unit `m/s`, found none
   --> knob.frob:3:53
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR (knob "speed" 0 0.5 0.2 i) 0))
    |                                           --------  ^^^^^^^^^^^^^^^^^^^^^^^^ this is `Float`
    |                                           |
    |                                           argument 1 of `setVelTR` is `Velocity` (m/s)
    |
    = hint: give the numbers their unit: `knob "speed" 0 0.5[m/s] 0.2[m/s] i`
  
  1 error
  [1]
  $ sed 's,0 0.5 0.2,0 0.5[m/s] 0.2[m/s],' knob.frob > cured.frob
  $ frobc check cured.frob

The signature may be wrong:

  $ cat > signature.frob <<'FROB'
  > import Robot
  > 
  > odometer :: SF RobotInput Velocity
  > odometer = proc i -> integral (velocity i)
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (if odometer i > 1[m/s] then 0 else 0.3[m/s]) 0))
  > FROB
  $ frobc check signature.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> signature.frob:4:22
    |
  3 | odometer :: SF RobotInput Velocity
    |             ---------------------- the signature of `odometer` requires the output `Velocity` (m/s)
  4 | odometer = proc i -> integral (velocity i)
    |                      ^^^^^^^^^^^^^^^^^^^^^ this is `Float[m]`
    |
    = hint: remove `integral`: `velocity i` is already in `m/s`
    = hint: if this is the right result, write the signature as `odometer :: SF RobotInput Float[m]`
  
  1 error
  [1]
  $ sed 's,Velocity,Distance,;s,1.m/s.,1[m],' signature.frob > cured.frob
  $ frobc check cured.frob

An angular velocity is an angle divided by a time:

  $ cat > turn.frob <<'FROB'
  > import Robot
  > 
  > kTurn :: Float[rad/m]
  > kTurn = 1.5[rad/m]
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] omega) where
  >     omega = kTurn * (sideSonar i - 0.5[m]))
  > FROB
  $ frobc check turn.frob
  error[E0320]: expected the unit `1/s`, found none
   --> turn.frob:6:61
    |
  6 | main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] omega) where
    |                                           --------          ^^^^^ this is `Float`
    |                                           |
    |                                           argument 2 of `setVelTR` is `AngularVelocity` (1/s)
    |
    = hint: multiply the plain number by a unit or a gain in `1/s`, as in `1[1/s] * omega`
  
  1 error
  [1]
  $ sed 's,1.5.rad/m.,1.5[1/(m s)],;s,rad/m,1/(m s),' turn.frob > cured.frob
  $ frobc check cured.frob

`delay` delays by one instant:

  $ cat > delay.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = delay 0.5[s] (0.5[1/s] * frontSonar i))
  > FROB
  $ frobc check delay.frob
  error[E0320]: expected the unit `s`, found `m/s`
   --> delay.frob:4:23
    |
  4 |     v = delay 0.5[s] (0.5[1/s] * frontSonar i))
    |         ----- ------  ^^^^^^^^^^^^^^^^^^^^^^^ this is `Float[m/s]`
    |         |     |
    |         |     because this is `Float[s]`
    |         argument 2 of `delay` is `Float[s]`
    |
    = hint: to delay by a fixed time, write `delayBy 0.5[s] (0.5[1/s] * frontSonar i)`, with `import Control`; `delay x0` delays by one instant, and `x0` is its output at the first instant
  
  1 error
  [1]
  $ sed 's,delay 0.5.s.,delay 0,' delay.frob > cured.frob
  $ frobc check cured.frob
