Switches whose event is an argument, and events used as values.

  $ cat > in_an_equation.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR (v i) 0)) where
  >     v = switch slow (when (1 > 0)) (\_ -> constant 0.4[m/s])
  >     slow = constant 0.1[m/s]
  > FROB
  $ frobc check in_an_equation.frob
  error[E0301]: the event of `switch` is no argument of its own
   --> in_an_equation.frob:3:22
    |
  3 |     v = switch slow (when (1 > 0)) (\_ -> constant 0.4[m/s])
    |                ----  ^^^^^^^^^^^^
    |                |
    |                it stands beside the output of this
    |
    = hint: write `switch (proc x -> (slow x, when (1 > 0))) (\_ -> constant 0.4[m/s])`
  
  1 error
  [1]

  $ cat > three_arguments.frob <<'FROB'
  > import Robot
  > cruise = proc i -> roMake (setVelTR 0.2[m/s] 0)
  > back = proc i -> roMake (setVelTR (-0.2[m/s]) 0)
  > main = reactimateRobot (switch cruise (proc i -> edge (frontSonar i < 0.5[m])) (\_ -> back))
  > FROB
  $ frobc check three_arguments.frob
  error[E0301]: the event of `switch` is no argument of its own
   --> three_arguments.frob:4:40
    |
  4 | main = reactimateRobot (switch cruise (proc i -> edge (frontSonar i < 0.5[m])) (\_ -> back))
    |                                ------  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |                                |
    |                                it stands beside the output of this
    |
    = hint: write `switch (cruise &&& (proc i -> edge (frontSonar i < 0.5[m]))) (\_ -> back)`
  
  1 error
  [1]

  $ cat > three_and_a_signal.frob <<'FROB'
  > f :: SF Float Float
  > f = proc x -> y where
  >     y = switch (constant 1) (edge (x > 2)) (constant 3) x
  > FROB
  $ frobc check three_and_a_signal.frob
  error[E0301]: the event of `switch` is no argument of its own
   --> three_and_a_signal.frob:3:30
    |
  3 |     y = switch (constant 1) (edge (x > 2)) (constant 3) x
    |                 ----------   ^^^^^^^^^^^^
    |                 |
    |                 it stands beside the output of this
    |
    = hint: write `switch (proc x -> (constant 1 x, edge (x > 2))) (\_ -> constant 3) x`
  
  1 error
  [1]

  $ cat > edge_float.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = if isEvent (edge (frontSonar i)) then 0 else 0.2[m/s])
  > FROB
  $ frobc check edge_float.frob
  error[E0301]: expected `Bool`, found `Distance` (m)
   --> edge_float.frob:3:27
    |
  3 |     v = if isEvent (edge (frontSonar i)) then 0 else 0.2[m/s])
    |                     ----  ^^^^^^^^^^^^
    |                     |
    |                     argument 1 of `edge` is `Bool`
    |
    = hint: no number is True or False: a comparison is, as in `frontSonar i < 1[m]`
  
  1 error
  [1]

  $ cat > event_and_bool.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = if bumped i && every 1[s] () then 0 else 0.2[m/s])
  > FROB
  $ frobc check event_and_bool.frob
  error[E0301]: expected `Bool`, found `Event ()`
   --> event_and_bool.frob:3:24
    |
  3 |     v = if bumped i && every 1[s] () then 0 else 0.2[m/s])
    |            --------    ^^^^^^^^^^^^^
    |            |
    |            this is `Bool`
    |
    = hint: `isEvent (every 1[s] ())` tells whether it occurs now; `gate (every 1[s] ()) (bumped i)` is the event where that is True, too
  
  1 error
  [1]

  $ cat > hold_bool.frob <<'FROB'
  > main :: SF Bool Float
  > main = proc b -> hold 0 (if b then 1 else 0)
  > FROB
  $ frobc check hold_bool.frob
  error[E0301]: expected `Event n[u]`, found a number
   --> hold_bool.frob:2:36
    |
  2 | main = proc b -> hold 0 (if b then 1 else 0)
    |                  ---- -            ^
    |                  |    |
    |                  |    because this is a number
    |                  argument 2 of `hold` is `Event n[u]`
    |
    = hint: this has a value at every instant, and needs no `hold`, which keeps that of an event; `tag e 1` is an event with the value that it has where `e` occurs
  
  1 error
  [1]

  $ cat > accum_wrong.frob <<'FROB'
  > main :: SF (Event ()) Int
  > main = proc e -> accumHold 0 (+1) e
  > FROB
  $ frobc check accum_wrong.frob
  error[E0301]: `accumHold` takes no function of its own
   --> accum_wrong.frob:2:30
    |
  2 | main = proc e -> accumHold 0 (+1) e
    |                              ^^^^ - the event brings it
    |
    = hint: write `accumHold 0 (tag e (+1))`
  
  1 error
  [1]

  $ cat > mapE_signal.frob <<'FROB'
  > main :: SF (Event Float) (Event Float)
  > main = proc e -> map (\x -> x * 2) e
  > FROB
  $ frobc check mapE_signal.frob
  error[E0301]: expected `Array m n[u]`, found `Event Float`
   --> mapE_signal.frob:2:36
    |
  2 | main = proc e -> map (\x -> x * 2) e
    |                  ---               ^
    |                  |
    |                  argument 2 of `map` is `Array m n[u]`
    |
    = hint: a function of an event's value is applied by `mapE`
  
  1 error
  [1]

  $ cat > switch_value.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = switch (0.2[m/s], edge (bumped i)) (\_ -> 0))
  > FROB
  $ frobc check switch_value.frob
  error[E0301]: expected `SF a (b, Event c)`, found `(Float[m/s], Event ())`
   --> switch_value.frob:3:16
    |
  3 |     v = switch (0.2[m/s], edge (bumped i)) (\_ -> 0))
    |         ------ ^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |         |
    |         argument 1 of `switch` is `SF a (b, Event c)`
    |
    = hint: what is switched are signal functions, each of which gets its signal by itself: `switch (proc i -> (0.2[m/s], edge (bumped i))) …`, and where that is to be run, `i` behind it all
  
  1 error
  [1]

  $ cat > camera_direct.frob <<'FROB'
  > import Robot
  > import Vision
  > red = ColourRange { hueFrom = 340, hueTo = 20, saturationFrom = 0.5, saturationTo = 1, valueFrom = 0.2, valueTo = 1 }
  > main = reactimateRobot (proc i -> roMake (setVelTR 0 0) where
  >     b = findBlob (camera i) (everywhere (camera i)) red)
  > FROB
  $ frobc check camera_direct.frob
  warning[W0303]: this angle is more than a whole turn: it is in radians
   --> camera_direct.frob:3:31
    |
  3 | red = ColourRange { hueFrom = 340, hueTo = 20, saturationFrom = 0.5, saturationTo = 1, valueFrom = 0.2, valueTo = 1 }
    |                               ^^^
    |
    = hint: for degrees write `340[deg]`
  
  warning[W0303]: this angle is more than a whole turn: it is in radians
   --> camera_direct.frob:3:44
    |
  3 | red = ColourRange { hueFrom = 340, hueTo = 20, saturationFrom = 0.5, saturationTo = 1, valueFrom = 0.2, valueTo = 1 }
    |                                            ^^
    |
    = hint: for degrees write `20[deg]`
  
  error[E0301]: expected `Image`, found `Event Frame`
   --> camera_direct.frob:5:19
    |
  5 |     b = findBlob (camera i) (everywhere (camera i)) red)
    |         --------  ^^^^^^^^
    |         |
    |         argument 1 of `findBlob` is `Image`
    |
    = hint: an event has a value only where it occurs: `mapE (\x -> findBlob x.image …) (camera i)` is the event of what `findBlob` makes of it
  
  1 error, 2 warnings
  [1]

  $ cat > camera_hold.frob <<'FROB'
  > import Robot
  > import Vision
  > main = reactimateRobot (proc i -> roMake (setVelTR 0 w) where
  >     f = camera i
  >     w = if f.number > 3 then 1[rad/s] else 0)
  > FROB
  $ frobc check camera_hold.frob
  error[E0310]: `Event Frame` has no field `number`
   --> camera_hold.frob:5:14
    |
  5 |     w = if f.number > 3 then 1[rad/s] else 0)
    |            - ^^^^^^
    |            |
    |            this is `Event Frame`
    |
    = hint: an event has a value only where it occurs: `mapE (\x -> x.number) f` is the event of its `number`, and `hold x0` keeps the latest one, at first `x0`
  
  1 error
  [1]

  $ cat > time_now.frob <<'FROB'
  > main = proc x -> if time.now > 3[s] then x else 0
  > FROB
  $ frobc check time_now.frob
  error[E0310]: `SF a Time` has no field `now`
   --> time_now.frob:1:26
    |
  1 | main = proc x -> if time.now > 3[s] then x else 0
    |                     ---- ^^^
    |                     |
    |                     this is `SF a Time`
    |
    = hint: it is a signal function, and what it gives is `time x`
  
  1 error
  [1]

  $ cat > after_if.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = if after 5[s] then 0 else 0.2[m/s])
  > FROB
  $ frobc check after_if.frob
  error[E0303]: a signal function stands where the value of its signal is needed
   --> after_if.frob:3:12
    |
  3 |     v = if after 5[s] then 0 else 0.2[m/s])
    |            ^^^^^^^^^^ this is `SF a (Event ())`
    |
    = note: expected `Bool`
    = hint: it gives events; what is True or False is `elapsed 5[s] ()`
  
  1 error
  [1]

  $ cat > event_arith.frob <<'FROB'
  > main :: SF (Event Int) (Event Int)
  > main = proc e -> e + 1
  > FROB
  $ frobc check event_arith.frob
  error[E0301]: expected a number, found `Event Int`
   --> event_arith.frob:2:18
    |
  2 | main = proc e -> e + 1
    |                  ^ - argument 1 of `+` is a number
    |
    = hint: an event has a value only where it occurs: `hold x0 e` is the latest one, at first `x0`; `mapE (\x -> x + 1) e` computes with each one
  
  1 error
  [1]
