Bools, events, functions and signal functions, each used instead of another.

  $ cat > after.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = if after 5[s] () then 0 else 0.2[m/s])
  > FROB
  $ frobc check after.frob
  error[E0301]: a condition must be `Bool`, but this is `Event ()`
   --> after.frob:3:12
    |
  3 |     v = if after 5[s] () then 0 else 0.2[m/s])
    |            ^^^^^^^^^^^^^
    |
    = hint: this occurs at only one instant: write `elapsed 5[s] ()`, which is True from then on
  
  1 error
  [1]

  $ cat > when.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = when (frontSonar i < 0.5[m]) 0 0.2[m/s])
  > FROB
  $ frobc check when.frob
  error[E0302]: `when` takes 1 argument, but is applied to more
   --> when.frob:3:38
    |
  3 |     v = when (frontSonar i < 0.5[m]) 0 0.2[m/s])
    |         ----                         ^ one too many
    |         |
    |         with one argument, its result is `Event ()`
    |
    = hint: for a choice between two values, write `if c then a else b`; for a task that runs only if a condition holds, write `whenT c t`
  
  1 error
  [1]

  $ cat > function.frob <<'FROB'
  > speedUp :: Float -> Float
  > speedUp x = integral x
  > main :: SF Float Float
  > main = proc x -> speedUp x
  > FROB
  $ frobc check function.frob
  error[E0320]: expected no unit, found `s`
   --> function.frob:2:13
    |
  1 | speedUp :: Float -> Float
    |            -------------- the signature of `speedUp` requires `Float`
  2 | speedUp x = integral x
    |             ^^^^^^^^^^ this is `Float[s]`
    |
    = hint: to get a plain number, divide by the unit: `(integral x) / 1[s]`
    = hint: `integral` is a signal function: run it in a `proc`, as in `speedUp = proc x -> …`, with the type `SF … …`
  
  1 error
  [1]

A signature with a function type: reported at the definition, and not again where it is used.

  $ cat > signature.frob <<'FROB'
  > import Robot
  > go :: RobotInput -> RobotOutput
  > go = switch (proc i -> (roMake (setVelTR 0.2[m/s] 0), edge (frontSonar i < 0.5[m]))) (\_ -> rest)
  > rest :: SF RobotInput RobotOutput
  > rest = proc _ -> roMake (setVelTR 0 0)
  > main = reactimateRobot go
  > FROB
  $ frobc check signature.frob
  error[E0304]: expected a function, found a signal function: `SF RobotInput RobotOutput`
   --> signature.frob:3:6
    |
  2 | go :: RobotInput -> RobotOutput
    |       ------------------------- the signature of `go` requires `RobotInput -> RobotOutput`
  3 | go = switch (proc i -> (roMake (setVelTR 0.2[m/s] 0), edge (frontSonar i < 0.5[m]))) (\_ -> rest)
    |      ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: if you want a signal function, change the type to `SF RobotInput RobotOutput`
  
  1 error
  [1]

  $ cat > unit_pattern.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (switch (proc i -> (roMake (setVelTR 0.2[m/s] 0), tag (edge (bumped i)) (frontSonar i))) (\() -> proc _ -> roMake (setVelTR 0 0)))
  > FROB
  $ frobc check unit_pattern.frob
  error[E0301]: expected `Distance` (m), found `()`
   --> unit_pattern.frob:2:115
    |
  2 | main = reactimateRobot (switch (proc i -> (roMake (setVelTR 0.2[m/s] 0), tag (edge (bumped i)) (frontSonar i))) (\() -> …
    |                         ------  ------------------------------------------------------------------------------    ^^
    |                         |       |
    |                         |       because this is `SF a (b, Event Distance)`
    |                         argument 2 of `switch` is `Distance` (m)
    |
    = hint: the signature is `switch :: SF a (b, Event c) -> (c -> SF a b) -> SF a b`
    = hint: use `_`, which matches every value
  
  1 error
  [1]

  $ cat > until.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (go `until` edge bumped)
  > go = proc i -> roMake (setVelTR 0.2[m/s] 0)
  > FROB
  $ frobc check until.frob
  error[E0205]: unknown name `until`
   --> until.frob:2:29
    |
  2 | main = reactimateRobot (go `until` edge bumped)
    |                             ^^^^^
    |
    = hint: to run another signal function after an event, use `switch`; to end a task when an event occurs, write ``t `abortWhen` sf``
  
  1 error
  [1]

  $ cat > input_of_a_task.frob <<'FROB'
  > import Robot
  > main = reactimateTask (do
  >     let d = frontSonar i
  >     if d < 0.5[m] then turnBy 90[deg] else forwardT)
  > forwardT = forward 1[m]
  > FROB
  $ frobc check input_of_a_task.frob
  error[E0205]: unknown name `i`
   --> input_of_a_task.frob:3:24
    |
  3 |     let d = frontSonar i
    |                        ^
    |
    = hint: only a `proc` can name the robot's input, as in `proc i -> …`; in a task, write `d <- ask frontSonar` to read a sensor once
  
  1 error
  [1]
