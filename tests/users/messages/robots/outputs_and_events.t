A robot's output is expected, but something else is found: reported once, with
what is missing.

  $ cat > composed.frob <<'FROB'
  > import Robot
  > main = reactimateRobot $ proc i -> roMake . setVelTR 0.2[m/s] 0
  > FROB
  $ frobc check composed.frob
  error[E0360]: there is no instance `DiffDrive (b -> b)`
     --> composed.frob:2:45
      |
    2 | main = reactimateRobot $ proc i -> roMake . setVelTR 0.2[m/s] 0
      |                                             ^^^^^^^^ `setVelTR` needs it
      |
     ::: stdlib/Capability.frob:223:17
      |
  223 |     setVelTR :: Velocity -> AngularVelocity -> o -> o
      |                 ------------------------------------- `setVelTR` requires `DiffDrive o` here
      |
      = hint: `.` composes functions: put a function and its arguments in parentheses, as in `roMake (setVelTR v omega)`
  
  1 error
  [1]

  $ cat > speeds.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (switch (proc i -> (0.2[m/s], edge (bumped i))) (\_ -> proc _ -> roMake (setVelTR 0 0)))
  > FROB
  $ frobc check speeds.frob
  error[E0360]: there is no instance `RobotOutput Float[m/s]`
     --> speeds.frob:2:89
      |
    2 | main = reactimateRobot (switch (proc i -> (0.2[m/s], edge (bumped i))) (\_ -> proc _ -> roMake (setVelTR 0 0)))
      |                                                                                         ^^^^^^ `roMake` needs it
      |
     ::: stdlib/Capability.frob:216:11
      |
  216 | roMake :: RobotOutput o => (o -> o) -> o
      |           ------------------------------ `roMake` requires `RobotOutput o` here
      |
      = hint: `roMake` returns commands for a robot: the signature or the other outputs here must also have the type `RobotOutput`, not `Float[m/s]`
  
  1 error
  [1]

  $ cat > no_event.frob <<'FROB'
  > import Robot
  > main = reactimateTask (mkTask (proc i -> roMake (setVelTR 0.2[m/s] 0)))
  > FROB
  $ frobc check no_event.frob
  error[E0360]: a pair of an output and an event is needed here, but `roMake` returns only an output
   --> no_event.frob:2:42
    |
  2 | main = reactimateTask (mkTask (proc i -> roMake (setVelTR 0.2[m/s] 0)))
    |                                          ^^^^^^
    |
    = hint: return a pair of the output and an event: `(roMake (setVelTR 0.2[m/s] 0), after 1[s] ())` ends the mode after 1 s, and `(…, edge c)` ends it when a condition `c` becomes True
  
  1 error
  [1]

  $ cat > hidden.frob <<'FROB'
  > import Robot
  > main = reactimateTask (do
  >     forward <- ask frontSonar
  >     forward 1[m])
  > FROB
  $ frobc check hidden.frob
  error[E0302]: `forward` is `Float[m]`, not a function
   --> hidden.frob:4:5
    |
  3 |     forward <- ask frontSonar
    |     ------- the name refers to this local `forward`
  4 |     forward 1[m])
    |     ^^^^^^^ ---- it is applied to an argument here
  
  1 error
  [1]
