Switches whose event is an argument, and events used as values.

  $ cat > in_an_equation.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR (v i) 0)) where
  >     v = switch slow (when (1 > 0)) (\_ -> constant 0.4[m/s])
  >     slow = constant 0.1[m/s]
  > FROB
  $ frobc check in_an_equation.frob
  error[E0301]: the event of `switch` is not a separate argument
   --> in_an_equation.frob:3:22
    |
  3 |     v = switch slow (when (1 > 0)) (\_ -> constant 0.4[m/s])
    |                ----  ^^^^^^^^^^^^
    |                |
    |                this mode must return the event together with its output
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
  error[E0301]: the event of `switch` is not a separate argument
   --> three_arguments.frob:4:40
    |
  4 | main = reactimateRobot (switch cruise (proc i -> edge (frontSonar i < 0.5[m])) (\_ -> back))
    |                                ------  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |                                |
    |                                this mode must return the event together with its output
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
  error[E0301]: the event of `switch` is not a separate argument
   --> three_and_a_signal.frob:3:30
    |
  3 |     y = switch (constant 1) (edge (x > 2)) (constant 3) x
    |                 ----------   ^^^^^^^^^^^^
    |                 |
    |                 this mode must return the event together with its output
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
    = hint: a number is neither True nor False: write a comparison, as in `frontSonar i < 1[m]`
  
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
    = hint: use `isEvent (every 1[s] ())`, which is True when the event occurs, or `gate (every 1[s] ()) (bumped i)` for an event that occurs only while the condition is True
  
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
    = hint: this has a value at every instant: to keep its value from the latest occurrence of an event `e`, write `hold 0 (tag e 1)`; otherwise, remove the `hold`
  
  1 error
  [1]

  $ cat > accum_wrong.frob <<'FROB'
  > main :: SF (Event ()) Int
  > main = proc e -> accumHold 0 (+1) e
  > FROB
  $ frobc check accum_wrong.frob
  error[E0301]: `accumHold` does not take a function as an argument
   --> accum_wrong.frob:2:30
    |
  2 | main = proc e -> accumHold 0 (+1) e
    |                              ^^^^ - the event must carry the function
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
    = hint: to apply a function to an event's value, write `mapE (\x -> x * 2) e`
  
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
    = hint: `switch` needs a signal function that returns the pair: write `switch (proc i -> (0.2[m/s], edge (bumped i))) (\_ -> 0) i`
  
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
  error[E0301]: expected `Image`, found `Event Frame`
   --> camera_direct.frob:5:19
    |
  5 |     b = findBlob (camera i) (everywhere (camera i)) red)
    |         --------  ^^^^^^^^
    |         |
    |         argument 1 of `findBlob` is `Image`
    |
    = hint: an event has a value only when it occurs: write `mapE (\x -> findBlob x.image …) (camera i)` for an event with the result of `findBlob`
  
  warning[W0303]: this angle is in radians, so it is more than a whole turn
   --> camera_direct.frob:3:31
    |
  3 | red = ColourRange { hueFrom = 340, hueTo = 20, saturationFrom = 0.5, saturationTo = 1, valueFrom = 0.2, valueTo = 1 }
    |                               ^^^
    |
    = hint: if you meant degrees, write `340[deg]`
  
  warning[W0303]: this angle is in radians, so it is more than a whole turn
   --> camera_direct.frob:3:44
    |
  3 | red = ColourRange { hueFrom = 340, hueTo = 20, saturationFrom = 0.5, saturationTo = 1, valueFrom = 0.2, valueTo = 1 }
    |                                            ^^
    |
    = hint: if you meant degrees, write `20[deg]`
  
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
    = hint: an event has a value only when it occurs: write `mapE (\x -> x.number) f` for an event with its `number`; to keep the latest value, apply `hold x0` to that event, where `x0` is the initial value
  
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
    = hint: it is a signal function; its output is `time x`
  
  1 error
  [1]

  $ cat > after_if.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = if after 5[s] then 0 else 0.2[m/s])
  > FROB
  $ frobc check after_if.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> after_if.frob:3:12
    |
  3 |     v = if after 5[s] then 0 else 0.2[m/s])
    |            ^^^^^^^^^^ this is `SF a (Event ())`
    |
    = note: expected `Bool`
    = hint: its output is an event: to use the event as a condition, write `elapsed 5[s] ()`
  
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
    = hint: an event has a value only when it occurs: write `hold 0 e` for its latest value, which is 0 at first, or `mapE (\x -> x + 1) e` to compute with each value
  
  1 error
  [1]
