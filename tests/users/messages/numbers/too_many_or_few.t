One argument too many, or a missing first one: the message shows the function's arguments, or its
syntax.

  $ cat > turn.frob <<'FROB'
  > import Robot
  > import Driving
  > main = reactimateTask (do
  >     forward 0.3[m/s] 2[m]
  >     turnBy 90[deg] 0.5[rad/s])
  > FROB
  $ frobc check turn.frob
  error[E0320]: expected the unit `m`, found `m/s`
   --> turn.frob:4:13
    |
  4 |     forward 0.3[m/s] 2[m]
    |     ------- ^^^^^^^^ this is `Float[m/s]`
    |     |
    |     argument 1 of `forward` is `Distance` (m)
    |
    = hint: `forward` takes one argument, but is applied to 2: `forward :: Distance -> Task i o Bool`
  
  error[E0302]: `turnBy` takes 1 argument, but is given 2
   --> turn.frob:5:20
    |
  5 |     turnBy 90[deg] 0.5[rad/s])
    |     ------         ^^^^^^^^^^ one too many
    |     |
    |     with one argument, its result is `Task a b Bool`
    |
    = hint: `turnBy :: Angle -> Task i o Bool`
  
  2 errors
  [1]

  $ cat > drive.frob <<'FROB'
  > import Robot
  > import Driving
  > main = reactimateTask (forward 2[m] 0.3[m/s])
  > FROB
  $ frobc check drive.frob
  error[E0302]: `forward` takes 1 argument, but is given 2
   --> drive.frob:3:37
    |
  3 | main = reactimateTask (forward 2[m] 0.3[m/s])
    |                        -------      ^^^^^^^^ one too many
    |                        |
    |                        with one argument, its result is `Task a b Bool`
    |
    = hint: `forward :: Distance -> Task i o Bool`
  
  1 error
  [1]

  $ cat > label.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = if buttonHeld i then 0.2[m/s] else 0)
  > FROB
  $ frobc check label.frob
  error[E0301]: expected `Bool`, found the function `a -> Bool`
   --> label.frob:3:12
    |
  3 |     v = if buttonHeld i then 0.2[m/s] else 0)
    |            ^^^^^^^^^^^^
    |
    = hint: `buttonHeld` takes two arguments, `buttonHeld label i`, but `label` is missing here: write, for example, `buttonHeld "label" i`
  
  1 error
  [1]

  $ cat > knob.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR (knob "speed" 0.4[m/s] i) 0))
  > FROB
  $ frobc check knob.frob
  error[E0301]: expected `Velocity` (m/s), found the function `Float[m/s] -> a -> Float[m/s]`
   --> knob.frob:2:53
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR (knob "speed" 0.4[m/s] i) 0))
    |                                           --------  ^^^^^^^^^^^^^^^^^^^^^^^
    |                                           |
    |                                           argument 1 of `setVelTR` is `Velocity` (m/s)
    |
    = hint: `knob` takes 5 arguments, `knob label least most first i`, but `most` and `first` are missing here: write, for example, `knob "speed" 0.4[m/s] most first i`
  
  1 error
  [1]

  $ cat > gains.frob <<'FROB'
  > import Robot
  > import Control
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     err = frontSonar i - 0.5[m]
  >     v = pid err)
  > FROB
  $ frobc check gains.frob
  error[E0301]: expected `Pid[u, v]`, found `Float[m]`
   --> gains.frob:5:13
    |
  5 |     v = pid err)
    |         --- ^^^
    |         |
    |         argument 1 of `pid` is `Pid[u, v]`
    |
    = hint: write the record before `err`: `pid (Pid { kp = …, ki = …, kd = …, largest = … }) err`
  
  1 error
  [1]

  $ cat > filter.frob <<'FROB'
  > import Control
  > main :: SF Distance Distance
  > main = proc d -> lowPass d
  > FROB
  $ frobc check filter.frob
  error[E0301]: `lowPass` lacks an argument before `d`
   --> filter.frob:3:26
    |
  3 | main = proc d -> lowPass d
    |                  ------- ^
    |                  |
    |                  `lowPass :: Time -> SF Float[u] Float[u]`
    |
    = hint: write `lowPass 1[s] d`, with the value that you want in place of `1[s]`
  
  1 error
  [1]

  $ cat > pair.frob <<'FROB'
  > import Past
  > main :: SF (Bool, Velocity) Velocity
  > main = proc (stop, v) -> w where
  >     w = if stop then 0 else v
  >     assert "stops" (respondsWithin 1[s] stop (w == 0))
  > FROB
  $ frobc check pair.frob
  error[E0301]: expected `(Bool, Bool)`, found `Bool`
   --> pair.frob:5:41
    |
  5 |     assert "stops" (respondsWithin 1[s] stop (w == 0))
    |                     --------------      ^^^^
    |                     |
    |                     argument 2 of `respondsWithin` is `(Bool, Bool)`
    |
    = hint: `respondsWithin` takes one tuple with 2 elements: write `respondsWithin 1[s] (stop, w == 0)`
  
  1 error
  [1]

  $ cat > index.frob <<'FROB'
  > import Robot
  > main :: (HasSonarRing i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = if sonars i [3] < 0.4[m] then 0 else 0.3[m/s])
  > FROB
  $ frobc check index.frob
  error[E0302]: `sonars` takes 1 argument, but is given 2
   --> index.frob:4:21
    |
  4 |     v = if sonars i [3] < 0.4[m] then 0 else 0.3[m/s])
    |            ------   ^^^ one too many
    |            |
    |            with one argument, its result is `Array 16 Sonar`
    |
    = hint: write `sonars i ! 3` for that element; the first element is `! 0`
  
  1 error
  [1]

  $ cat > output.frob <<'FROB'
  > import Control
  > main :: SF (Distance, Velocity) Distance
  > main = proc (d, v) -> do
  >     a <- lowPass 0.1[s] -< d
  >     b <- integral -< v
  >     returnA -< a b
  > FROB
  $ frobc check output.frob
  error[E0302]: `a` is `Float[m]`, not a function
   --> output.frob:6:16
    |
  4 |     a <- lowPass 0.1[s] -< d
    |     - the name refers to this local `a`
  5 |     b <- integral -< v
  6 |     returnA -< a b
    |                ^ - it is applied to an argument here
    |
    = hint: write an operator between the two values, as in `a * b`; for a tuple, `(a, b)`
  
  1 error
  [1]

Tasks in sequence, under a condition, and with a time:

  $ cat > forever.frob <<'FROB'
  > import Robot
  > import Driving
  > main = reactimateTask (forever
  >     forward 1[m]
  >     turnBy 90[deg])
  > FROB
  $ frobc check forever.frob
  error[E0301]: expected `Task a b c`, found the function `Distance -> Task d e Bool`
   --> forever.frob:4:5
    |
  3 | main = reactimateTask (forever
    |                        ------- argument 1 of `forever` is `Task a b c`
  4 |     forward 1[m]
    |     ^^^^^^^
    |
    = hint: put `do` before a sequence of tasks
  
  1 error
  [1]

  $ cat > when.frob <<'FROB'
  > import Robot
  > import Driving
  > import Geometry
  > main = reactimateTask (do
  >     ok <- driveTo (Vec2 { x = 1[m], y = 0 })
  >     when (not ok) (turnBy 90[deg])
  >     forward 1[m])
  > FROB
  $ frobc check when.frob
  error[E0302]: `when` takes 1 argument, but is given 2
   --> when.frob:6:20
    |
  6 |     when (not ok) (turnBy 90[deg])
    |     ----           ^^^^^^^^^^^^^^ one too many
    |     |
    |     with one argument, its result is `Event ()`
    |
    = hint: for a choice between two values, write `if c then a else b`; for a task that runs only if a condition holds, write `whenT c t`
  
  1 error
  [1]

  $ cat > time_out.frob <<'FROB'
  > import Robot
  > import Driving
  > main = reactimateTask (do
  >     timeOut 5[s] (forward 2[m])
  >     turnBy 90[deg])
  > FROB
  $ frobc check time_out.frob
  error[E0301]: the arguments of `timeOut` are in the wrong order
   --> time_out.frob:4:5
    |
  4 |     timeOut 5[s] (forward 2[m])
    |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: write `timeOut (forward 2[m]) 5[s]`
  
  1 error
  [1]

  $ cat > repeat.frob <<'FROB'
  > import Robot
  > import Driving
  > main = reactimateTask (repeatT (do
  >     forward 1[m]
  >     turnBy 90[deg]) 4)
  > FROB
  $ frobc check repeat.frob
  error[E0301]: the arguments of `repeatT` are in the wrong order
   --> repeat.frob:3:24
    |
  3 | main = reactimateTask (repeatT (do
    |                        ^^^^^^^^^^^
  4 |     forward 1[m]
  5 |     turnBy 90[deg]) 4)
    |     ^^^^^^^^^^^^^^^^^
    |
    = hint: write `repeatT 4 (…)`
  
  1 error
  [1]
