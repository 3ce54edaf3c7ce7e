Mistakes of newcomers with events, modes and robots. Every replacement that a message offers compiles
when it is pasted.

Exchanged arguments of `hold`:

  $ cat > hold.frob <<'FROB'
  > f :: SF (Event Float) Float
  > f = proc e -> hold e 0
  > FROB
  $ frobc check hold.frob
  error[E0301]: the arguments of `hold` are in the wrong order
   --> hold.frob:2:15
    |
  2 | f = proc e -> hold e 0
    |               ^^^^^^^^
    |
    = hint: write `hold 0 e`
  
  1 error
  [1]
  $ sed 's:hold e 0:hold 0 e:' hold.frob > pasted.frob && frobc check pasted.frob



  $ cat > held.frob <<'FROB'
  > f :: SF Distance Distance
  > f = proc d -> hold (when (d > 1[m])) d
  > FROB
  $ frobc check held.frob
  error[E0301]: expected `Event (Event ())`, found `Distance` (m)
   --> held.frob:2:38
    |
  2 | f = proc d -> hold (when (d > 1[m])) d
    |               ----  ---------------  ^
    |               |     |
    |               |     because this is `Event ()`
    |               argument 2 of `hold` is `Event (Event ())`
    |
    = hint: `hold` takes the initial value first, and then an event that carries the value: write `hold 0 (tag (when (d > 1[m])) d)`
  
  1 error
  [1]
  $ sed 's:hold (when (d > 1\[m\])) d:hold 0 (tag (when (d > 1[m])) d):' held.frob > pasted.frob && frobc check pasted.frob

An event in an event:

  $ cat > wrapped.frob <<'FROB'
  > f :: SF Float (Event ())
  > f = proc x -> tag (edge (x > 1)) (Event ())
  > FROB
  $ frobc check wrapped.frob
  error[E0301]: expected `Event ()`, found `Event (Event ())`
   --> wrapped.frob:2:15
    |
  1 | f :: SF Float (Event ())
    |      ------------------- the signature of `f` requires the output `Event ()`
  2 | f = proc x -> tag (edge (x > 1)) (Event ())
    |               ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: `tag` creates the event: pass only the value, `tag (edge (x > 1)) ()`
  
  1 error
  [1]
  $ sed '/tag/s:(Event ())$:():' wrapped.frob > pasted.frob && frobc check pasted.frob



  $ cat > wrapped_edge.frob <<'FROB'
  > f :: SF Bool (Event ())
  > f = proc b -> Event (edge b)
  > FROB
  $ frobc check wrapped_edge.frob
  error[E0301]: expected `Event ()`, found `Event (Event ())`
   --> wrapped_edge.frob:2:15
    |
  1 | f :: SF Bool (Event ())
    |      ------------------ the signature of `f` requires the output `Event ()`
  2 | f = proc b -> Event (edge b)
    |               ^^^^^^^^^^^^^^
    |
    = hint: the content is already an event: write `edge b` without `Event`
  
  1 error
  [1]
  $ sed 's:Event (edge b):edge b:' wrapped_edge.frob > pasted.frob && frobc check pasted.frob

An event that is compared with a number:

  $ cat > compared.frob <<'FROB'
  > f :: SF (Event Float) Bool
  > f = proc e -> e < 3
  > FROB
  $ frobc check compared.frob
  error[E0301]: expected a number, found `Event Float`
   --> compared.frob:2:15
    |
  2 | f = proc e -> e < 3
    |               ^   - this is a number
    |
    = hint: an event has a value only when it occurs: write `hold 30 e` for its latest value; the initial value `30` makes the comparison False
  
  1 error
  [1]
  $ sed 's:e < 3:hold 0 e < 3:' compared.frob > pasted.frob && frobc check pasted.frob



  $ cat > compared_record.frob <<'FROB'
  > import Robot
  > f :: SF RobotInput Bool
  > f = proc i -> robotPose i > 90[deg]
  > FROB
  $ frobc check compared_record.frob
  error[E0301]: expected `Float`, found `Pose`
   --> compared_record.frob:3:15
    |
  3 | f = proc i -> robotPose i > 90[deg]
    |               ^^^^^^^^^^^   ------- this is `Float`
    |
    = hint: this is a record: choose one of its fields, `(robotPose i).position`, `(robotPose i).heading`
  
  1 error
  [1]
  $ sed 's:robotPose i >:(robotPose i).heading >:' compared_record.frob > pasted.frob && frobc check pasted.frob

An argument that is missing before an event:

  $ cat > missing_start.frob <<'FROB'
  > f :: SF Bool Int
  > f = proc b -> accumHoldBy (\n _ -> n + 1) (edge b)
  > FROB
  $ frobc check missing_start.frob
  error[E0301]: expected a number, found `Event ()`
   --> missing_start.frob:2:44
    |
  2 | f = proc b -> accumHoldBy (\n _ -> n + 1) (edge b)
    |               -----------  -------------   ^^^^^^
    |               |            |
    |               |            because this is `n[1] -> a -> n[1]`
    |               argument 2 of `accumHoldBy` is a number
    |
    = hint: an argument is missing before this one, a number: write `accumHoldBy (\n _ -> n + 1) 0 (edge b)`
  
  1 error
  [1]
  $ sed 's:(edge b):0 (edge b):' missing_start.frob > pasted.frob && frobc check pasted.frob

A program that does not use its input:

  $ cat > program.frob <<'FROB'
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (proc () -> roMake (setVelTR 0.2[m/s] 0))
  > FROB
  $ frobc check program.frob
  error[E0301]: expected the input `RobotInput`, found `()`
   --> program.frob:3:30
    |
  2 | main :: Program RobotInput RobotOutput
    |         ------------------------------ the signature of `main` requires `Program RobotInput RobotOutput`
  3 | main = reactimateRobot (proc () -> roMake (setVelTR 0.2[m/s] 0))
    |                              ^^
    |
    = hint: if the program does not use its input, write `proc _ -> …`
  
  1 error
  [1]
  $ sed 's:proc ():proc _:' program.frob > pasted.frob && frobc check pasted.frob

An input that is a pair, with one name:

  $ cat > whole_input.frob <<'FROB'
  > f :: SF (Float, Float) Float
  > f = proc x -> x + 1
  > FROB
  $ frobc check whole_input.frob
  error[E0301]: expected a number, found `(Float, Float)`
   --> whole_input.frob:2:15
    |
  2 | f = proc x -> x + 1
    |          -    ^ - argument 1 of `+` is a number
    |          |
    |          this is one name for the whole tuple
    |
    = hint: `x` is the whole input: take it apart in the pattern, as in `proc (a, b) -> …`
  
  1 error
  [1]
  $ sed 's:proc x -> x + 1:proc (a, b) -> a + b + 1:' whole_input.frob > pasted.frob && frobc check pasted.frob



  $ cat > too_many_inputs.frob <<'FROB'
  > f :: SF (Float, Float) Float
  > f = proc (a, b, c) -> a + b
  > FROB
  $ frobc check too_many_inputs.frob
  error[E0301]: expected a tuple with 2 elements, found one with 3
   --> too_many_inputs.frob:2:10
    |
  1 | f :: SF (Float, Float) Float
    |      ----------------------- the signature of `f` requires the input `(Float, Float)`
  2 | f = proc (a, b, c) -> a + b
    |          ^^^^^^^^^ this is `(a, b, c)`
    |
    = hint: write the pattern as `(a, b)`
  
  1 error
  [1]
  $ sed 's:(a, b, c):(a, b):' too_many_inputs.frob > pasted.frob && frobc check pasted.frob

A record as an output:

  $ cat > own_output.frob <<'FROB'
  > import Robot
  > data Out = Out { speed :: Velocity, braked :: Bool }
  > main = reactimateRobot (proc _ -> roMake (\o -> o { speed = 0.1[m/s] }) :: SF RobotInput Out)
  > FROB
  $ frobc check own_output.frob
  error[E0360]: there is no instance `RobotOutput Out`
     --> own_output.frob:3:35
      |
    3 | main = reactimateRobot (proc _ -> roMake (\o -> o { speed = 0.1[m/s] }) :: SF RobotInput Out)
      |                                   ^^^^^^ `roMake` needs it
      |
     ::: stdlib/Capability.frob:216:11
      |
  216 | roMake :: RobotOutput o => (o -> o) -> o
      |           ------------------------------ `roMake` requires `RobotOutput o` here
      |
      = hint: for a robot of your own, define its output at rest: `instance RobotOutput Out where restingOutput = Out { speed = 0, braked = False }`; for a Pioneer, use the type `RobotOutput`
  
  1 error
  [1]
  $ sed 's:^main:instance RobotOutput Out where restingOutput = Out { speed = 0, braked = False }\nmain:' own_output.frob > pasted.frob && frobc check pasted.frob

Numbers as an output:

  $ cat > numbers_as_output.frob <<'FROB'
  > import Robot
  > main = reactimateTask (sleepT 1[s] (0.3[m/s], 0[rad/s]))
  > FROB
  $ frobc check numbers_as_output.frob
  error[E0360]: there is no instance `RobotOutput (Float[m/s], n[1/s])`
    --> numbers_as_output.frob:2:8
     |
   2 | main = reactimateTask (sleepT 1[s] (0.3[m/s], 0[rad/s]))
     |        ^^^^^^^^^^^^^^ `reactimateTask` needs it
     |
    ::: stdlib/Robot.frob:44:19
     |
  44 | reactimateTask :: RobotOutput o => Task i o c -> Program i o
     |                   ------------------------------------------ `reactimateTask` requires `RobotOutput o` here
     |
     = hint: a robot takes commands, not numbers: turn the speed and the turn rate into an output with `roMake (setVelTR v omega)`
  
  1 error
  [1]
  $ sed 's:(0.3\[m/s\], 0\[rad/s\]):(roMake (setVelTR 0.3[m/s] 0)):' numbers_as_output.frob > pasted.frob && frobc check pasted.frob



  $ cat > speeds.frob <<'FROB'
  > import Robot
  > f :: SF RobotInput (Velocity, AngularVelocity)
  > f = proc _ -> roMake (setVelTR 0.3[m/s] 0)
  > FROB
  $ frobc check speeds.frob
  error[E0360]: there is no instance `RobotOutput (Velocity, AngularVelocity)`
     --> speeds.frob:3:15
      |
    3 | f = proc _ -> roMake (setVelTR 0.3[m/s] 0)
      |               ^^^^^^ `roMake` needs it
      |
     ::: stdlib/Capability.frob:216:11
      |
  216 | roMake :: RobotOutput o => (o -> o) -> o
      |           ------------------------------ `roMake` requires `RobotOutput o` here
      |
      = hint: `roMake` returns commands for a robot: the signature or the other outputs here must also have the type `RobotOutput`, not `(Velocity, AngularVelocity)`
  
  1 error
  [1]
  $ sed 's:(Velocity, AngularVelocity):RobotOutput:' speeds.frob > pasted.frob && frobc check pasted.frob

A sensor that is applied to something other than the robot:

  $ cat > sonar_of_a_speed.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = 0.5[1/s] * (frontSonar v - 0.5[m]))
  > FROB
  $ frobc check sonar_of_a_speed.frob
  error[E0360]: there is no instance `HasSonar Float[m/s]`
    --> sonar_of_a_speed.frob:3:21
     |
   3 |     v = 0.5[1/s] * (frontSonar v - 0.5[m]))
     |                     ^^^^^^^^^^ `frontSonar` needs it
     |
    ::: stdlib/Capability.frob:48:19
     |
  48 |     frontSonar :: SF i Distance
     |                   ------------- `frontSonar` requires `HasSonar i` here
     |
     = hint: `frontSonar` takes the robot's input, not `Float[m/s]`: in `proc i -> …`, write `frontSonar i`
  
  1 error
  [1]
  $ sed 's:frontSonar v:frontSonar i:' sonar_of_a_speed.frob > pasted.frob && frobc check pasted.frob

A missing argument, by its name:

  $ cat > missing_limit.frob <<'FROB'
  > import Control
  > f :: SF Velocity Velocity
  > f = proc v -> clamp 0 v
  > FROB
  $ frobc check missing_limit.frob
  error[E0301]: expected `Velocity` (m/s), found the function `Float[m/s] -> Float[m/s]`
   --> missing_limit.frob:3:15
    |
  2 | f :: SF Velocity Velocity
    |      -------------------- the signature of `f` requires the output `Velocity` (m/s)
  3 | f = proc v -> clamp 0 v
    |               ^^^^^^^^^
    |
    = hint: `clamp` takes 3 arguments, `clamp low high y`, but `high` is missing here: write, for example, `clamp 0 high v`
  
  1 error
  [1]
  $ sed 's:clamp 0 v:clamp 0 1[m/s] v:' missing_limit.frob > pasted.frob && frobc check pasted.frob



  $ cat > missing_turn.frob <<'FROB'
  > import Robot
  > f :: SF RobotInput RobotOutput
  > f = proc _ -> roMake (setVelTR 0.3[m/s])
  > FROB
  $ frobc check missing_turn.frob
  error[E0301]: expected a function that takes one argument, found one that takes 2: `AngularVelocity -> a -> a`
   --> missing_turn.frob:3:23
    |
  3 | f = proc _ -> roMake (setVelTR 0.3[m/s])
    |               ------  ^^^^^^^^^^^^^^^^^
    |               |
    |               argument 1 of `roMake` is `o -> o`
    |
    = hint: `setVelTR` lacks its second argument, `AngularVelocity` (1/s): write `setVelTR 0.3[m/s] 0`, for example
  
  1 error
  [1]
  $ sed 's:(setVelTR 0.3\[m/s\]):(setVelTR 0.3[m/s] 0):' missing_turn.frob > pasted.frob && frobc check pasted.frob

A sensor in a task:

  $ cat > equation_in_a_task.frob <<'FROB'
  > import Robot
  > t :: Task RobotInput RobotOutput Bool
  > t = do
  >     x = frontSonar
  >     if x < 1[m] then forward 1[m] else return False
  > FROB
  $ frobc check equation_in_a_task.frob
  error[E0110]: expected `<-`, `-<`, or the end of this statement, found `=`
   --> equation_in_a_task.frob:4:7
    |
  4 |     x = frontSonar
    |       ^
    |
    = hint: for the result of a task, write `x <- frontSonar`; for the current value of a sensor or other signal function, `x <- ask frontSonar`; for a value, `let x = frontSonar`
  
  1 error
  [1]
  $ sed 's:x = frontSonar:x <- ask frontSonar:' equation_in_a_task.frob > pasted.frob && frobc check pasted.frob



  $ cat > value_in_a_task.frob <<'FROB'
  > import Robot
  > t :: Task RobotInput RobotOutput ()
  > t = do
  >     v = 0.3[m/s]
  >     sleepT 1[s] (roMake (setVelTR v 0))
  > FROB
  $ frobc check value_in_a_task.frob
  error[E0110]: expected `<-`, `-<`, or the end of this statement, found `=`
   --> value_in_a_task.frob:4:7
    |
  4 |     v = 0.3[m/s]
    |       ^
    |
    = hint: for a value, write `let v = 0.3[m/s]`; for the result of a task `t`, write `v <- t`
  
  1 error
  [1]
  $ sed 's:v = 0.3:let v = 0.3:' value_in_a_task.frob > pasted.frob && frobc check pasted.frob



  $ cat > let_in_a_task.frob <<'FROB'
  > import Robot
  > t :: Task RobotInput RobotOutput Bool
  > t = do
  >     let x = frontSonar
  >     if x < 1[m] then forward 1[m] else return False
  > FROB
  $ frobc check let_in_a_task.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> let_in_a_task.frob:5:8
    |
  4 |     let x = frontSonar
    |             ---------- this defines `x`
  5 |     if x < 1[m] then forward 1[m] else return False
    |        ^   ---- this is a number in `m`
    |        |
    |        this is `SF a Distance`
    |
    = hint: in a task, first read the current value: write `x <- ask frontSonar` in place of `let x = frontSonar`
  
  1 error
  [1]
  $ sed 's:let x = frontSonar:x <- ask frontSonar:' let_in_a_task.frob > pasted.frob && frobc check pasted.frob

A mode without an event:

  $ cat > no_event.frob <<'FROB'
  > f :: SF Float Float
  > f = switch (proc x -> x) (\_ -> constant 0)
  > FROB
  $ frobc check no_event.frob
  error[E0301]: this mode of `switch` does not return an event
   --> no_event.frob:2:23
    |
  1 | f :: SF Float Float
    |      -------------- the signature of `f` requires `SF Float Float`
  2 | f = switch (proc x -> x) (\_ -> constant 0)
    |                       ^
    |
    = hint: the first argument of `switch` must return a pair of an output and an event: `(x, after 1[s] ())` ends the mode after 1 s, and `(…, edge c)` ends it when a condition `c` becomes True
  
  1 error
  [1]
  $ sed 's:proc x -> x):proc x -> (x, after 1[s] ())):' no_event.frob > pasted.frob && frobc check pasted.frob



  $ cat > no_event_sum.frob <<'FROB'
  > f :: SF Float Float
  > f = switch (proc x -> x + 1) (\_ -> constant 0)
  > FROB
  $ frobc check no_event_sum.frob
  error[E0301]: expected `(a, Event b)`, found a number
   --> no_event_sum.frob:2:23
    |
  2 | f = switch (proc x -> x + 1) (\_ -> constant 0)
    |     ------            ^^^^^
    |     |
    |     argument 1 of `switch` has the output `(a, Event b)`
    |
    = hint: the first argument of `switch` must return a pair of an output and an event: `(x + 1, after 1[s] ())` ends the mode after 1 s, and `(…, edge c)` ends it when a condition `c` becomes True
  
  1 error
  [1]
  $ sed 's:proc x -> x + 1):proc x -> (x + 1, after 1[s] ())):' no_event_sum.frob > pasted.frob && frobc check pasted.frob



  $ cat > no_event_constant.frob <<'FROB'
  > f :: SF Float Float
  > f = switch (constant 1) (\_ -> constant 0)
  > FROB
  $ frobc check no_event_constant.frob
  error[E0301]: expected `SF a (b, Event c)`, found `SF a n[1]`
   --> no_event_constant.frob:2:13
    |
  2 | f = switch (constant 1) (\_ -> constant 0)
    |     ------  ^^^^^^^^^^
    |     |
    |     argument 1 of `switch` is `SF a (b, Event c)`
    |
    = hint: return the output and the event that ends the mode: `(constant 1 &&& after 1[s])` ends it after 1 s; to end it when a condition `c` becomes True, return a pair, `(…, edge c)`
  
  1 error
  [1]
  $ sed 's:(constant 1):(constant 1 \&\&\& after 1[s]):' no_event_constant.frob > pasted.frob && frobc check pasted.frob

A signal that is held:

  $ cat > held_signal.frob <<'FROB'
  > f :: SF Distance Distance
  > f = proc d -> hold d
  > FROB
  $ frobc check held_signal.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> held_signal.frob:2:15
    |
  1 | f :: SF Distance Distance
    |      -------------------- the signature of `f` requires the output `Distance` (m)
  2 | f = proc d -> hold d
    |               ^^^^^^ this is `SF (Event Distance) Distance`
    |
    = note: expected `Distance` (m)
    = hint: `hold` keeps the value of an event, as in `hold x0 e`, but `d` has a value at every instant: write `d` alone
  
  1 error
  [1]
  $ sed 's:hold d:d:' held_signal.frob > pasted.frob && frobc check pasted.frob



  $ cat > delayed.frob <<'FROB'
  > f :: SF Float Float
  > f = proc x -> delay x
  > FROB
  $ frobc check delayed.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> delayed.frob:2:15
    |
  1 | f :: SF Float Float
    |      -------------- the signature of `f` requires the output `Float`
  2 | f = proc x -> delay x
    |               ^^^^^^^ this is `SF Float Float`
    |
    = note: expected `Float`
    = hint: `delay` takes an initial value before its signal: write `delay 0 x`
  
  1 error
  [1]
  $ sed 's:delay x:delay 0 x:' delayed.frob > pasted.frob && frobc check pasted.frob

A pose in place of a position:

  $ cat > pose.frob <<'FROB'
  > import Robot
  > import Geometry
  > f :: SF RobotInput Bool
  > f = proc i -> distance (robotPose i) goal < 0.1[m] where
  >     goal = Vec2 { x = 1[m], y = 0 }
  > FROB
  $ frobc check pose.frob
  error[E0301]: expected `Vec2[u]`, found `Pose`
   --> pose.frob:4:25
    |
  4 | f = proc i -> distance (robotPose i) goal < 0.1[m] where
    |               --------  ^^^^^^^^^^^
    |               |
    |               argument 1 of `distance` is `Vec2[u]`
    |
    = hint: use its field: `(robotPose i).position`
  
  1 error
  [1]
  $ sed 's:(robotPose i):(robotPose i).position:' pose.frob > pasted.frob && frobc check pasted.frob

Numbers in place of a position:

  $ cat > two_numbers.frob <<'FROB'
  > import Robot
  > go :: Task RobotInput RobotOutput Bool
  > go = driveTo (1, 2)
  > FROB
  $ frobc check two_numbers.frob
  error[E0301]: expected `Point2`, found a tuple with 2 elements
   --> two_numbers.frob:3:14
    |
  3 | go = driveTo (1, 2)
    |      ------- ^^^^^^
    |      |
    |      argument 1 of `driveTo` is `Point2`
    |
    = hint: write a vector with its field names: `Vec2 { x = 1[m], y = 2[m] }`, with `import Geometry`
  
  1 error
  [1]
  $ sed 's:(1, 2):(Vec2 { x = 1[m], y = 2[m] }):; s:^import.*:import Robot\nimport Geometry:' two_numbers.frob > pasted.frob && frobc check pasted.frob

A comma between arguments:

  $ cat > comma.frob <<'FROB'
  > import Robot
  > f :: SF RobotInput RobotOutput
  > f = proc _ -> roMake (setVelTR 0.3[m/s], 0)
  > FROB
  $ frobc check comma.frob
  error[E0301]: expected `a -> a`, found `(AngularVelocity -> b -> b, n[u])`
   --> comma.frob:3:22
    |
  3 | f = proc _ -> roMake (setVelTR 0.3[m/s], 0)
    |               ------ ^^^^^^^^^^^^^^^^^^^^^^
    |               |
    |               argument 1 of `roMake` is `o -> o`
    |
    = hint: a comma makes a tuple: separate the arguments with spaces, `(setVelTR 0.3[m/s] 0)`
  
  1 error
  [1]
  $ sed 's:(setVelTR 0.3\[m/s\], 0):(setVelTR 0.3[m/s] 0):' comma.frob > pasted.frob && frobc check pasted.frob

An event next to the mode that it ends:

  $ cat > pair_of_a_mode.frob <<'FROB'
  > import Robot
  > f :: SF RobotInput RobotOutput
  > f = switch (proc _ -> roMake (setVelTR 0.3[m/s] 0), after 1[s] ()) (\_ -> constant restingOutput)
  > FROB
  $ frobc check pair_of_a_mode.frob
  error[E0301]: expected `SF a (b, Event c)`, found `(SF d e, Event ())`
   --> pair_of_a_mode.frob:3:12
    |
  3 | f = switch (proc _ -> roMake (setVelTR 0.3[m/s] 0), after 1[s] ()) (\_ -> constant restingOutput)
    |     ------ ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |     |
    |     argument 1 of `switch` is `SF a (b, Event c)`
    |
    = hint: `switch` needs a signal function that returns the pair: write `switch (proc _ -> (roMake (setVelTR 0.3[m/s] 0), after 1[s] ())) …`
  
  1 error
  [1]
  $ sed 's:(proc _ -> roMake (setVelTR 0.3\[m/s\] 0), after 1\[s\] ()):(proc _ -> (roMake (setVelTR 0.3[m/s] 0), after 1[s] ())):' pair_of_a_mode.frob > pasted.frob && frobc check pasted.frob

A condition in place of the next mode:

  $ cat > next_mode.frob <<'FROB'
  > import Robot
  > f :: SF RobotInput RobotOutput
  > f = switch cruise bumped where
  >     cruise = proc i -> (roMake (setVelTR 0.3[m/s] 0), edge (bumped i))
  > FROB
  $ frobc check next_mode.frob
  error[E0301]: expected `() -> SF a b`, found `() -> Bool`
   --> next_mode.frob:3:19
    |
  3 | f = switch cruise bumped where
    |     ------ ------ ^^^^^^
    |     |      |
    |     |      because this is `SF a (b, Event ())`
    |     argument 2 of `switch` is `() -> SF a b`
    |
    = hint: the second argument of `switch` takes the value of the event and returns the next mode: `\_ -> …`; the event itself belongs in the output of the first argument, as in `(output, edge b)`
  
  1 error
  [1]
  $ sed 's:cruise bumped:cruise (\\_ -> constant restingOutput):' next_mode.frob > pasted.frob && frobc check pasted.frob

A value of an event that lacks its unit:

  $ cat > value_of_an_event.frob <<'FROB'
  > f :: SF Bool (Event Velocity)
  > f = proc b -> tag (edge b) 0.5
  > FROB
  $ frobc check value_of_an_event.frob
  error[E0320]: expected the unit `m/s`, found none
   --> value_of_an_event.frob:2:15
    |
  1 | f :: SF Bool (Event Velocity)
    |      ------------------------ the signature of `f` requires the output `Event Velocity`
  2 | f = proc b -> tag (edge b) 0.5
    |               ^^^^^^^^^^^^^^^^ this is `Event Float`
    |
    = note: expected `Event Velocity`, found `Event Float`
    = hint: write `0.5[m/s]` if that is the right unit
  
  1 error
  [1]
  $ sed 's:0.5:0.5[m/s]:' value_of_an_event.frob > pasted.frob && frobc check pasted.frob



  $ cat > event_when.frob <<'FROB'
  > f :: SF Float (Event Float)
  > f = proc x -> Event x when (x > 1)
  > FROB
  $ frobc check event_when.frob
  error[E0302]: `Event` takes 1 argument, but is given 3
   --> event_when.frob:2:23
    |
  2 | f = proc x -> Event x when (x > 1)
    |               -----   ^^^^ too many from here on
    |               |
    |               with one argument, its result is `Event Float`
    |
    = hint: for an event that has the value `x` and occurs whenever a condition is True, write `tag (when condition) x`
  
  1 error
  [1]
  $ sed 's:Event x when (x > 1):tag (when (x > 1)) x:' event_when.frob > pasted.frob && frobc check pasted.frob



  $ cat > sonar_of_an_input.frob <<'FROB'
  > import Robot
  > t :: Task RobotInput RobotOutput Bool
  > t = do
  >     d = frontSonar i
  >     forward d
  > FROB
  $ frobc check sonar_of_an_input.frob
  error[E0110]: expected `<-`, `-<`, or the end of this statement, found `=`
   --> sonar_of_an_input.frob:4:7
    |
  4 |     d = frontSonar i
    |       ^
    |
    = hint: for a value, write `let d = frontSonar i`; for the current value of a sensor, `d <- ask frontSonar`
  
  1 error
  [1]
  $ sed 's:d = frontSonar i:d <- ask frontSonar:' sonar_of_an_input.frob > pasted.frob && frobc check pasted.frob
