The components of a pair in the wrong order: reported once, for the pair, even if one of them alone
would fit.

A recurring switch, whose output may be anything:

  $ cat > ramp.frob <<'FROB'
  > import Robot
  > 
  > ramp :: SF Bool Float
  > ramp = proc b -> v where
  >     v = rSwitch (constant 0) (when b `tag` constant 1, b)
  > FROB
  $ frobc check ramp.frob
  error[E0301]: the two parts of this pair are in the wrong order
   --> ramp.frob:5:30
    |
  5 |     v = rSwitch (constant 0) (when b `tag` constant 1, b)
    |         -------              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |         |
    |         argument 2 of `rSwitch` is `(a, Event (SF a n[u]))`
    |
    = hint: write `(b, when b `tag` constant 1)`
  
  1 error
  [1]

  $ cat > recurring.frob <<'FROB'
  > main :: SF (Bool, Float) Float
  > main = proc (b, x) -> y where
  >     y = rSwitch integral (tag (edge b) integral, x)
  > FROB
  $ frobc check recurring.frob
  error[E0301]: the two parts of this pair are in the wrong order
   --> recurring.frob:3:26
    |
  3 |     y = rSwitch integral (tag (edge b) integral, x)
    |         -------          ^^^^^^^^^^^^^^^^^^^^^^^^^^
    |         |
    |         argument 2 of `rSwitch` is `(Float[u], Event (SF Float[u] Float[u s]))`
    |
    = hint: write `(x, tag (edge b) integral)`
  
  1 error
  [1]

  $ cat > robot.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = rSwitch (constant 0.2[m/s]) (edge (frontSonar i < 0.5[m]) `tag` constant 0, i))
  > FROB
  $ frobc check robot.frob
  error[E0301]: the two parts of this pair are in the wrong order
   --> robot.frob:3:37
    |
  3 |     v = rSwitch (constant 0.2[m/s]) (edge (frontSonar i < 0.5[m]) `tag` constant 0, i))
    |         -------                     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |         |
    |         argument 2 of `rSwitch` is `(a, Event (SF a Float[m/s]))`
    |
    = hint: write `(i, edge (frontSonar i < 0.5[m]) `tag` constant 0)`
  
  1 error
  [1]

An output and the event that ends it: the event has no instance of the output's class.

  $ cat > ends.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (switch (proc i -> (after 2[s] (), roMake (setVelTR 0.2[m/s] 0))) (\_ -> proc i -> roMake (setVelTR 0 0)))
  > FROB
  $ frobc check ends.frob
  error[E0301]: the two parts of this pair are in the wrong order
   --> ends.frob:2:43
    |
  2 | main = reactimateRobot (switch (proc i -> (after 2[s] (), roMake (setVelTR 0.2[m/s] 0))) (\_ -> proc i -> roMake (setVel…
    |                         ------            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |                         |
    |                         argument 1 of `switch` has the output `(a, Event b)`
    |
    = hint: write `(roMake (setVelTR 0.2[m/s] 0), after 2[s] ())`
  
  1 error
  [1]

  $ cat > task.frob <<'FROB'
  > import Robot
  > go = mkTask (proc i -> (edge (frontSonar i < 0.5[m]), roMake (setVelTR 0.2[m/s] 0)))
  > main = reactimateTask go
  > FROB
  $ frobc check task.frob
  error[E0301]: the two parts of this pair are in the wrong order
   --> task.frob:2:24
    |
  2 | go = mkTask (proc i -> (edge (frontSonar i < 0.5[m]), roMake (setVelTR 0.2[m/s] 0)))
    |      ------            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |      |
    |      argument 1 of `mkTask` has the output `(a, Event b)`
    |
    = hint: write `(roMake (setVelTR 0.2[m/s] 0), edge (frontSonar i < 0.5[m]))`
  
  1 error
  [1]

A reset:

  $ cat > reset.frob <<'FROB'
  > main :: SF (Bool, Float) Float
  > main = proc (b, x) -> y where
  >     y = resetOn integral (edge b, x)
  > FROB
  $ frobc check reset.frob
  error[E0301]: the two parts of this pair are in the wrong order
   --> reset.frob:3:26
    |
  3 |     y = resetOn integral (edge b, x)
    |         -------          ^^^^^^^^^^^
    |         |
    |         argument 2 of `resetOn` is `(Float[u], Event ())`
    |
    = hint: write `(x, edge b)`
  
  1 error
  [1]

The output in a signature, which may itself be wrong:

  $ cat > output.frob <<'FROB'
  > import Robot
  > drive :: HasSonar i => SF i (Velocity, AngularVelocity)
  > drive = proc i -> (w, v) where
  >     v = 0.2[m/s]
  >     w = if frontSonar i < 0.5[m] then 1[rad/s] else 0
  > main = reactimateRobot (proc i -> roMake (setVelTR v w) where
  >     (v, w) = drive i)
  > FROB
  $ frobc check output.frob
  error[E0301]: the two parts of this pair are in the wrong order
   --> output.frob:3:19
    |
  2 | drive :: HasSonar i => SF i (Velocity, AngularVelocity)
    |          ---------------------------------------------- the signature of `drive` requires the output `(Velocity, AngularVelocity)`
  3 | drive = proc i -> (w, v) where
    |                   ^^^^^^
    |
    = hint: write `(v, w)`, or swap their types in the signature
  
  1 error
  [1]

Separate arguments, and a tuple:

  $ cat > one_tuple.frob <<'FROB'
  > mix :: (Float, Float) -> Float
  > mix x y = x + y
  > main :: SF Float Float
  > main = proc x -> mix (x, x)
  > FROB
  $ frobc check one_tuple.frob
  error[E0302]: `mix` has more than one parameter, but its type allows only one
   --> one_tuple.frob:2:7
    |
  1 | mix :: (Float, Float) -> Float
    |        ----------------------- the signature of `mix` requires `(Float, Float) -> Float`
  2 | mix x y = x + y
    |       ^
    |
    = hint: the signature has one parameter, a tuple: write `mix (x, y) = …`, or write `->` between the types
  
  1 error
  [1]

  $ cat > several.frob <<'FROB'
  > mix :: Float -> Float -> Float
  > mix (x, y) = x + y
  > main :: SF Float Float
  > main = proc x -> mix x x
  > FROB
  $ frobc check several.frob
  error[E0301]: `mix` takes 2 separate arguments, not a tuple
   --> several.frob:2:5
    |
  1 | mix :: Float -> Float -> Float
    |        ----------------------- the signature of `mix` requires `Float -> Float -> Float`
  2 | mix (x, y) = x + y
    |     ^^^^^^
    |
    = hint: write `mix x y = …`
  
  1 error
  [1]
