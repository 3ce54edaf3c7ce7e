Common first mistakes with a robot's sensors, speeds and tasks.

A sensor function without its input, read like a field, or in a task:

  $ cat > sonar_without_input.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = if frontSonar < 0.5[m] then 0 else 0.3[m/s])
  > FROB
  $ frobc check sonar_without_input.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> sonar_without_input.frob:4:12
    |
  4 |     v = if frontSonar < 0.5[m] then 0 else 0.3[m/s])
    |            ^^^^^^^^^^   ------ this is `Float[m]`
    |            |
    |            this is `SF a Distance`
    |
    = hint: run the signal function on `i`: `frontSonar i`
  
  1 error
  [1]
  $ cat > sonar_as_field.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = 0.5[1/s] * (i.frontSonar - 0.3[m]))
  > FROB
  $ frobc check sonar_as_field.frob
  error[E0310]: no type in scope has a field `frontSonar`
   --> sonar_as_field.frob:4:23
    |
  4 |     v = 0.5[1/s] * (i.frontSonar - 0.3[m]))
    |                       ^^^^^^^^^^
    |
    = hint: `frontSonar` is a signal function: write `frontSonar i`
  
  1 error
  [1]
  $ cat > sonar_in_a_task.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask go
  > 
  > go :: Task RobotInput RobotOutput ()
  > go = do
  >     i <- snapT
  >     if frontSonar i < 0.5[m]
  >       then return ()
  >       else sleepT 1[s] (roMake (setVelTR 0.2[m/s] 0))
  > FROB
  $ frobc check sonar_in_a_task.frob
  error[E0341]: `frontSonar` is run outside of a `proc`
   --> sonar_in_a_task.frob:8:8
    |
  8 |     if frontSonar i < 0.5[m]
    |        ^^^^^^^^^^^^ the statements of a task cannot run signal functions
    |
    = hint: to read it once, write `x <- ask frontSonar` before this, and `x` here
    = hint: to run it at every instant of a task, write `mkTask (proc i -> (output, event))`
  
  1 error
  [1]
  $ cat > signal_outside_proc.frob <<'FROB'
  > import Robot
  > 
  > speed = 0.5[1/s] * (frontSonar i - 0.3[m])
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR speed 0))
  > FROB
  $ frobc check signal_outside_proc.frob
  error[E0205]: unknown name `i`
   --> signal_outside_proc.frob:3:32
    |
  3 | speed = 0.5[1/s] * (frontSonar i - 0.3[m])
    |                                ^
  4 |
  5 | main = reactimateRobot (proc i -> roMake (setVelTR speed 0))
    |                              - this `i` is a signal of a `proc`
    |
    = hint: a signal can only be used inside its `proc`: move the equation to the `where` of that `proc`, or write a signal function with its own input: `proc i -> …`
  
  1 error
  [1]
  $ cat > mode_calls_itself.frob <<'FROB'
  > import Robot
  > 
  > drive :: SF RobotInput RobotOutput
  > drive = proc i -> if bumped i then roMake id else drive i
  > 
  > main = reactimateRobot drive
  > FROB
  $ frobc check mode_calls_itself.frob
  error[E0342]: `drive` is run in its own definition
   --> mode_calls_itself.frob:4:51
    |
  4 | drive = proc i -> if bumped i then roMake id else drive i
    |                                                   ^^^^^^^
    |
    = hint: an equation holds at every instant, so a signal function need not call itself to continue
    = hint: to change what runs after an event, use `switch (proc x -> (output, event)) (\_ -> …)`; replace `…` with the signal function to run next, which may be this one
  
  1 error
  [1]

A result that is not an output, or that takes time:

  $ cat > speed_as_output.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> if bumped i then 0 else 0.3[m/s])
  > FROB
  $ frobc check speed_as_output.frob
  error[E0411]: `main` cannot run: its type is `HasBumpers a => Program a Float[m/s]`, so its output is not a robot's output
   --> speed_as_output.frob:3:35
    |
  3 | main = reactimateRobot (proc i -> if bumped i then 0 else 0.3[m/s])
    |                                   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: use `roMake` to create a robot's output, as in `roMake (setVelTR v omega)`
  
  1 error
  [1]
  $ cat > task_started_in_proc.frob <<'FROB'
  > import Geometry
  > import Robot
  > 
  > main = reactimateRobot (proc i ->
  >     if bumped i then driveTo (Vec2 { x = 0, y = 0 }) else roMake (setVelTR 0.2[m/s] 0))
  > FROB
  $ frobc check task_started_in_proc.frob
  error[E0371]: `roMake` does not return a task, but `Task b c Bool` is needed here
   --> task_started_in_proc.frob:5:59
    |
  5 |     if bumped i then driveTo (Vec2 { x = 0, y = 0 }) else roMake (setVelTR 0.2[m/s] 0))
    |                                                           ^^^^^^
    |
    = hint: a robot command is not a task: in a `do`, write `sleepT 1[s] (roMake …)` to give it for a fixed time, or `mkTask (proc i -> (roMake …, e))` to give it until an event `e` occurs
  
  1 error
  [1]
  $ cat > place_as_two_numbers.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (do
  >     driveTo 1[m] 2[m]
  >     driveTo 0 0)
  > FROB
  $ frobc check place_as_two_numbers.frob
  error[E0301]: expected `Point2`, found a number in `m`
   --> place_as_two_numbers.frob:4:13
    |
  4 |     driveTo 1[m] 2[m]
    |     ------- ^^^^
    |     |
    |     argument 1 of `driveTo` is `Point2`
    |
    = hint: write a vector with its field names: `Vec2 { x = 1[m], y = 2[m] }`, with `import Geometry`
  
  error[E0301]: expected `Point2`, found a number
   --> place_as_two_numbers.frob:5:13
    |
  5 |     driveTo 0 0)
    |     ------- ^
    |     |
    |     argument 1 of `driveTo` is `Point2`
    |
    = hint: write a vector with its field names: `Vec2 { x = 0, y = 0 }`, with `import Geometry`
  
  2 errors
  [1]
  $ cat > task_ends_with_bind.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask go
  > 
  > go = do
  >     sleepT 1[s] (roMake (setVelTR 0.2[m/s] 0))
  >     p <- robotPlace
  > FROB
  $ frobc check task_ends_with_bind.frob
  error[E0116]: the last statement of a `do` must be a task, so it cannot bind a name
   --> task_ends_with_bind.frob:7:5
    |
  7 |     p <- robotPlace
    |     ^
    |
    = hint: remove `p <-` to return the task's result, or add a last statement such as `return p`
  
  1 error
  [1]

A capability that no robot has, or whose module is not imported:

  $ cat > setLight_on_pioneer.frob <<'FROB'
  > import Robot
  > 
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 0 . setLight On))
  > FROB
  $ frobc check setLight_on_pioneer.frob
  error[E0360]: a Pioneer does not have the capability `HasLight`, which `setLight` needs
     --> setLight_on_pioneer.frob:4:65
      |
    4 | main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 0 . setLight On))
      |                                                                 ^^^^^^^^ `setLight` needs it
      |
     ::: stdlib/Capability.frob:230:17
      |
  230 |     setLight :: Light -> o -> o
      |                 --------------- `setLight` requires `HasLight o` here
      |
      = note: `RobotOutput` is the output of a Pioneer
      = note: robots with `HasLight`: Create
      = hint: for such a robot, write `main :: (HasOdometry i, HasLight o) => Program i o`, and compile with `--robot create`
  
  1 error
  [1]
  $ cat > no_import_robot.frob <<'FROB'
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = 0.5[1/s] * (frontSonar i - 0.3[m]))
  > FROB
  $ frobc check no_import_robot.frob
  error[E0205]: unknown name `reactimateRobot`
   --> no_import_robot.frob:1:8
    |
  1 | main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
    |        ^^^^^^^^^^^^^^^
    |
    = hint: `reactimateRobot`, `roMake`, `setVelTR` and `frontSonar` are in the library: `import Robot`
  
  1 error
  [1]
