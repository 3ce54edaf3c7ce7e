Arguments in the wrong order: reported if they fit in another order.

A robot's speeds:

  $ cat > speeds.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc _ -> roMake (setVelTR 30[deg/s] 0.3[m/s]))
  > FROB
  $ frobc check speeds.frob
  error[E0320]: the arguments of `setVelTR` are in the wrong order
   --> speeds.frob:3:43
    |
  3 | main = reactimateRobot (proc _ -> roMake (setVelTR 30[deg/s] 0.3[m/s]))
    |                                           ^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: write `setVelTR 0.3[m/s] 30[deg/s]`
  
  1 error
  [1]
  $ sed 's,30.deg/s. 0.3.m/s.,0.3[m/s] 30[deg/s],' speeds.frob > cured.frob
  $ frobc check cured.frob

The event first:

  $ cat > hold.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = hold (tag (edge (bumped i)) 0) 0.3[m/s])
  > FROB
  $ frobc check hold.frob
  error[E0301]: the arguments of `hold` are in the wrong order
   --> hold.frob:4:9
    |
  4 |     v = hold (tag (edge (bumped i)) 0) 0.3[m/s])
    |         ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: write `hold 0.3[m/s] (tag (edge (bumped i)) 0)`
  
  1 error
  [1]
  $ sed 's,hold (.*) 0.3.m/s.),hold 0.3[m/s] (tag (edge (bumped i)) 0)),' hold.frob > cured.frob
  $ frobc check cured.frob

A position and its label:

  $ cat > label.frob <<'FROB'
  > import Display
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.1[m/s] 0 . draw (InWorld Red (label "here" (place i)))))
  > FROB
  $ frobc check label.frob
  error[E0301]: the arguments of `label` are in the wrong order
   --> label.frob:4:84
    |
  4 | main = reactimateRobot (proc i -> roMake (setVelTR 0.1[m/s] 0 . draw (InWorld Red (label "here" (place i)))))
    |                                                                                    ^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: write `label (place i) "here"`
  
  1 error
  [1]
  $ sed 's,"here" (place i),(place i) "here",' label.frob > cured.frob
  $ frobc check cured.frob

A number without its unit, in the right position:

  $ cat > no_unit.frob <<'FROB'
  > import Control
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = 0.5[1/s] * (lowPass 200 (frontSonar i) - 0.3[m]))
  > FROB
  $ frobc check no_unit.frob
  error[E0320]: expected the unit `s`, found none
   --> no_unit.frob:4:29
    |
  4 |     v = 0.5[1/s] * (lowPass 200 (frontSonar i) - 0.3[m]))
    |                     ------- ^^^ this is `Float`
    |                     |
    |                     argument 1 of `lowPass` is `Time` (s)
    |
    = hint: write `200[ms]` if these are milliseconds, or `200[s]` if these are seconds
  
  1 error
  [1]
  $ sed 's,200,200[ms],' no_unit.frob > cured.frob
  $ frobc check cured.frob

Two arguments that both fit any type are not exchanged:

  $ cat > alike.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = min 0.3[m/s] (tag (edge (bumped i)) 0))
  > FROB
  $ frobc check alike.frob
  error[E0301]: expected `Float[m/s]`, found `Event n[u]`
   --> alike.frob:3:23
    |
  3 |     v = min 0.3[m/s] (tag (edge (bumped i)) 0))
    |         --- --------  ^^^^^^^^^^^^^^^^^^^^^^^
    |         |   |
    |         |   because this is `Float[m/s]`
    |         argument 2 of `min` is `Float[m/s]`
    |
    = hint: an event has a value only when it occurs: write `hold 0 (tag (edge (bumped i)) 0)` for its latest value, which is 0 at first
  
  1 error
  [1]

Two arguments with the same unit are not exchanged: here the unit of the rate is wrong.

  $ cat > rate.frob <<'FROB'
  > import Control
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = rateLimit 0.5[m/s] (0.5[1/s] * frontSonar i))
  > FROB
  $ frobc check rate.frob 2>&1 | grep -e "^error" -e order
  error[E0320]: expected the unit `m/s^2`, found `m/s`
