Mistakes in first programs for robots.

A name that is not imported: the message names the module that combines everything that programs for
robots need.

  $ cat > no_import.frob <<'FROB'
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.3[m/s] 0))
  > FROB
  $ frobc check no_import.frob
  error[E0205]: unknown name `reactimateRobot`
   --> no_import.frob:1:8
    |
  1 | main = reactimateRobot (proc i -> roMake (setVelTR 0.3[m/s] 0))
    |        ^^^^^^^^^^^^^^^
    |
    = hint: `reactimateRobot`, `roMake` and `setVelTR` are in the library: `import Robot`
  
  1 error
  [1]

An angle where an angular velocity is expected.

  $ cat > degrees.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0 30[deg]))
  > FROB
  $ frobc check degrees.frob
  error[E0320]: expected the unit `1/s`, found none
   --> degrees.frob:2:54
    |
  2 | main = reactimateRobot (proc _ -> roMake (setVelTR 0 30[deg]))
    |                                           --------   ^^^^^^^ this is `Float`
    |                                           |
    |                                           argument 2 of `setVelTR` is `AngularVelocity` (1/s)
    |
    = hint: write `30[deg/s]` if this is the turn rate
  
  1 error
  [1]
  $ sed 's,30.deg.,30[deg/s],' degrees.frob > turning.frob
  $ frobc check turning.frob

An event where a Bool or a number is expected.

  $ cat > events.frob <<'FROB'
  > import Robot
  > 
  > stops :: HasBumpers i => SF i Float
  > stops = proc i -> if edge (bumped i) then 0 else 1
  > 
  > more :: SF (Event Float) Float
  > more = proc e -> e + 1
  > FROB
  $ frobc check events.frob
  error[E0301]: a condition must be `Bool`, but this is `Event ()`
   --> events.frob:4:22
    |
  4 | stops = proc i -> if edge (bumped i) then 0 else 1
    |                      ^^^^^^^^^^^^^^^
    |
    = hint: to test whether the condition is True, write `bumped i`; to test whether it becomes True in this instant, write `isEvent (edge (bumped i))`
  
  error[E0301]: expected a number, found `Event Float`
   --> events.frob:7:18
    |
  7 | more = proc e -> e + 1
    |                  ^ - argument 1 of `+` is a number
    |
    = hint: an event has a value only when it occurs: write `hold 0 e` for its latest value, which is 0 at first, or `mapE (\x -> x + 1) e` to compute with each value
  
  2 errors
  [1]

A position written as a pair.

  $ cat > place.frob <<'FROB'
  > import Robot
  > main = reactimateTask (driveTo (3, 4))
  > FROB
  $ frobc check place.frob
  error[E0301]: expected `Point2`, found a tuple with 2 elements
   --> place.frob:2:32
    |
  2 | main = reactimateTask (driveTo (3, 4))
    |                        ------- ^^^^^^
    |                        |
    |                        argument 1 of `driveTo` is `Point2`
    |
    = hint: write a vector with its field names: `Vec2 { x = 3[m], y = 4[m] }`, with `import Geometry`
  
  1 error
  [1]

The output of a robot without `roMake`.

  $ cat > no_make.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc _ -> setVelTR 0.1[m/s] 0)
  > FROB
  $ frobc check no_make.frob
  error[E0411]: `main` cannot run: its output is a function, `b -> b`, not a robot's output
   --> no_make.frob:2:35
    |
  2 | main = reactimateRobot (proc _ -> setVelTR 0.1[m/s] 0)
    |                                   ^^^^^^^^^^^^^^^^^^^
    |
    = hint: use `roMake` to turn this function into a robot's output, as in `roMake (setVelTR v omega)`
  
  1 error
  [1]

The same in a signal function, in a function, and if a signature states the output.

  $ cat > no_make.frob <<'FROB'
  > import Robot
  > main = proc i -> setVelTR 0.1[m/s] (if bumped i then 1[rad/s] else 0)
  > FROB
  $ frobc check no_make.frob
  error[E0411]: `main` cannot run: its output is a function, `b -> b`, not a robot's output
   --> no_make.frob:2:18
    |
  2 | main = proc i -> setVelTR 0.1[m/s] (if bumped i then 1[rad/s] else 0)
    |                  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: use `roMake` to turn this function into a robot's output, as in `roMake (setVelTR v omega)`
  
  1 error
  [1]
  $ cat > no_make.frob <<'FROB'
  > import Pioneer
  > import Robot
  > main :: SF PioneerInput (PioneerOutput -> PioneerOutput)
  > main = proc _ -> setVelTR 0.1[m/s] 0
  > FROB
  $ frobc check no_make.frob
  error[E0411]: `main` cannot run: its output is a function, `PioneerOutput -> PioneerOutput`, not a robot's output
   --> no_make.frob:4:18
    |
  4 | main = proc _ -> setVelTR 0.1[m/s] 0
    |                  ^^^^^^^^^^^^^^^^^^^
    |
    = hint: use `roMake` to turn this function into a robot's output, as in `roMake (setVelTR v omega)`
  
  1 error
  [1]
  $ cat > no_make.frob <<'FROB'
  > import Robot
  > main = setVelTR 0.1[m/s]
  > FROB
  $ frobc check no_make.frob
  error[E0411]: `main` cannot run: it is a function, `DiffDrive a => Float[1/s] -> a -> a`, not a signal function
   --> no_make.frob:2:1
    |
  2 | main = setVelTR 0.1[m/s]
    | ^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: to set a robot's output, write `reactimateRobot (proc i -> roMake (setVelTR v omega))`
  
  1 error
  [1]

The same if the output is that of a task, or of a signature.

  $ cat > no_make.frob <<'FROB'
  > import Robot
  > main = reactimateTask (do
  >     sleepT 1[s] (setVelTR 0.1[m/s] 0)
  >     sleepT 2[s] (setVelTR 0 1[rad/s])
  >     sleepT 1[s] (roMake (setVelTR 0.1[m/s] 0)))
  > FROB
  $ frobc check no_make.frob
  error[E0360]: there is no instance `RobotOutput (b -> b)`
    --> no_make.frob:2:8
     |
   2 | main = reactimateTask (do
     |        ^^^^^^^^^^^^^^ `reactimateTask` needs it
     |
    ::: stdlib/Robot.frob:44:19
     |
  44 | reactimateTask :: RobotOutput o => Task i o c -> Program i o
     |                   ------------------------------------------ `reactimateTask` requires `RobotOutput o` here
     |
     = hint: use `roMake` to turn this function into a robot's output, as in `roMake (setVelTR v omega)`
  
  1 error
  [1]
  $ cat > no_make.frob <<'FROB'
  > import Pioneer
  > import Robot
  > 
  > ahead :: DiffDrive o => SF i o
  > ahead = proc i -> setVelTR 0.1[m/s] 0
  > 
  > spin :: SF PioneerInput PioneerOutput
  > spin = proc i -> turning where
  >     turning = setVelTR 0 1[rad/s]
  > 
  > main :: Program PioneerInput PioneerOutput
  > main = reactimateRobot (proc i -> turning) where
  >     turning = setVelTR 0 1[rad/s]
  > FROB
  $ frobc check no_make.frob
  error[E0301]: expected `o`, found `a -> a`
   --> no_make.frob:5:19
    |
  4 | ahead :: DiffDrive o => SF i o
    |          --------------------- the signature of `ahead` requires the output `o`
  5 | ahead = proc i -> setVelTR 0.1[m/s] 0
    |                   ^^^^^^^^^^^^^^^^^^^ this is a function
    |
    = hint: this only changes an output: for the robot's output itself, write `roMake (setVelTR 0.1[m/s] 0)`
  
  error[E0301]: expected `PioneerOutput`, found `a -> a`
   --> no_make.frob:8:18
    |
  7 | spin :: SF PioneerInput PioneerOutput
    |         ----------------------------- the signature of `spin` requires the output `PioneerOutput`
  8 | spin = proc i -> turning where
    |                  ^^^^^^^
    |
    = hint: use `roMake` to turn this function into a robot's output, as in `roMake (setVelTR v omega)`
  
  error[E0301]: expected `Program PioneerInput PioneerOutput`, found `Program PioneerInput (a -> a)`
    --> no_make.frob:12:8
     |
  11 | main :: Program PioneerInput PioneerOutput
     |         ---------------------------------- the signature of `main` requires `Program PioneerInput PioneerOutput`
  12 | main = reactimateRobot (proc i -> turning) where
     |        ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
     |
     = hint: use `roMake` to turn this function into a robot's output, as in `roMake (setVelTR v omega)`
  
  3 errors
  [1]

A signature that requires too little.

  $ cat > asks.frob <<'FROB'
  > import Robot
  > 
  > main :: DiffDrive o => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (if bumped i then 0 else 0.1[m/s]) 0))
  > FROB
  $ frobc check asks.frob
  error[E0309]: `bumped` needs `HasBumpers i`, which the signature of `main` does not declare
    --> asks.frob:4:56
     |
   3 | main :: DiffDrive o => Program i o
     |         -------------------------- the signature of `main`
   4 | main = reactimateRobot (proc i -> roMake (setVelTR (if bumped i then 0 else 0.1[m/s]) 0))
     |                                                        ^^^^^^
     |
    ::: stdlib/Capability.frob:89:11
     |
  89 | bumped :: HasBumpers i => i -> Bool
     |           ------------------------- `bumped` requires `HasBumpers i` here
     |
     = hint: write `(DiffDrive o, HasBumpers i) => Program i o`
  
  1 error
  [1]

A signal function for a robot is a program for any robot with the required capabilities; without a
signature it is for a Pioneer, like a program.

  $ cat > logger.frob <<'FROB'
  > import Robot
  > 
  > logger :: HasOdometry i => SF i Float[m]
  > logger = proc i -> integral (abs (velocity i))
  > 
  > main = proc _ -> roMake (setVelTR 0.1[m/s] 0)
  > FROB
  $ frobc compile logger.frob --entry logger
  error[E0502]: the type of `logger` does not say which robot it runs on
   --> logger.frob:4:1
    |
  4 | logger = proc i -> integral (abs (velocity i))
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: `pioneer`, `scout`, `create` and `ros` have everything that the program needs: compile it with `--robot pioneer`, `--robot scout`, `--robot create` or `--robot ros`
  
  1 error
  [1]
  $ frobc compile logger.frob --entry logger --robot scout
  $ frobc run logger.frob --for 1s | head -1
  time simulated: 1.000 s

Words that are operators.

  $ cat > words.frob <<'FROB'
  > f :: Bool -> Bool -> Bool
  > f x y = x and y
  > FROB
  $ frobc check words.frob
  error[E0205]: Frob has no `and`
   --> words.frob:2:11
    |
  2 | f x y = x and y
    |           ^^^
    |
    = hint: write `&&` instead of `and`
  
  1 error
  [1]

A table that lacks most of the robot's sensors.

  $ printf 'time,in.odometry.heading\n0,1\n' > in.csv
  $ frobc trace logger.frob --input in.csv 2>&1 | cut -d';' -f1
  error: in.csv:1:1: missing: `in.odometry.position.x`, `in.odometry.position.y`, `in.leftWheel` and 24 more
  $ frobc trace logger.frob --input in.csv --engine interp 2>&1 | cut -d';' -f1
  error: in.csv:1:1: missing: `in.odometry.position.x`, `in.odometry.position.y`, `in.leftWheel` and 24 more

A program named without its extension, a number instead of a code.

  $ frobc run logger
  error: there is no file logger; did you mean logger.frob?
  [2]
  $ frobc explain 402 | head -1
  # signal functions or tasks that may start each other endlessly within one instant

A signature that requires too few capabilities is one mistake, whichever definition needs the
missing one.

  $ cat > promise.frob <<'FROB'
  > import Geometry
  > import Robot
  > 
  > straight :: Distance -> Task i o ()
  > straight way = do
  >     start <- robotPlace
  >     mkTask (proc i -> (roMake (setVelTR 0.3[m/s] 0),
  >         when (distance (place i) start >= way || frontSonar i < 0.4[m])))
  > FROB
  $ frobc check promise.frob
  error[E0309]: the signature of `straight` does not declare `DiffDrive o` and `HasSonar i`
   --> promise.frob:4:13
    |
  4 | straight :: Distance -> Task i o ()
    |             ^^^^^^^^^^^^^^^^^^^^^^^
  ...
  7 |     mkTask (proc i -> (roMake (setVelTR 0.3[m/s] 0),
    |                                -------- `setVelTR` needs `DiffDrive o`
  8 |         when (distance (place i) start >= way || frontSonar i < 0.4[m])))
    |                                                  ---------- `frontSonar` needs `HasSonar i`
    |
    = hint: write `(DiffDrive o, HasSonar i) => Distance -> Task i o ()`
  
  1 error
  [1]
