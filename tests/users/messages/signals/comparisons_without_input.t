A sensor or function that is compared without its input, where a signal function is expected:

  $ cat > abort.frob <<'FROB'
  > import Robot
  > import WallFollow
  > 
  > main = reactimateTask (watching trip)
  > 
  > trip :: (HasSonar i, HasBattery i, DiffDrive o) => Task i o (Either () ())
  > trip = wallFollowT 0.3[m] `abortWhen` (batteryVoltage < 12[V])
  > FROB
  $ frobc check abort.frob
  error[E0301]: `batteryVoltage` lacks its input
   --> abort.frob:7:40
    |
  7 | trip = wallFollowT 0.3[m] `abortWhen` (batteryVoltage < 12[V])
    |                                        ^^^^^^^^^^^^^^   ----- it is compared with this value
    |
    = hint: this place needs a signal function whose output is an event: write `(proc i -> edge (batteryVoltage i < 12[V]))`
  
  1 error
  [1]
  $ sed 's/(batteryVoltage.*/(proc i -> edge (batteryVoltage i < 12[V]))/' abort.frob > cured.frob
  $ frobc check cured.frob

The value may be on the left, and no event may be expected:

  $ cat > near.frob <<'FROB'
  > import Robot
  > 
  > near :: HasSonar i => SF i Bool
  > near = 0.3[m] > frontSonar
  > 
  > positive :: Float -> Bool
  > positive x = x > 0
  > 
  > main :: SF Float Bool
  > main = positive == True
  > FROB
  $ frobc check near.frob
  error[E0301]: `frontSonar` lacks its input
   --> near.frob:4:17
    |
  4 | near = 0.3[m] > frontSonar
    |        ------   ^^^^^^^^^^
    |        |
    |        this is `Float[m]`
    |
    = hint: this place needs a signal function: write `proc i -> 0.3[m] > frontSonar i`
  
  error[E0301]: `positive` lacks its input
    --> near.frob:10:8
     |
  10 | main = positive == True
     |        ^^^^^^^^    ---- it is compared with this value
     |
     = hint: this place needs a signal function: write `proc i -> positive i == True`
  
  2 errors
  [1]
  $ sed 's/^near = .*/near = proc i -> 0.3[m] > frontSonar i/;s/= positive ==/= proc i -> positive i ==/' near.frob > cured.frob
  $ frobc check cured.frob
