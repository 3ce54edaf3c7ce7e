Common first mistakes with choices, records, switches, arrays and positions, and with the end of a
`proc`.

A signal is in scope only in its `proc`, which ends at a bracket or comma:

  $ cat > bracket.frob <<'FROB'
  > import Robot
  > main = reactimateTask (forward 1[m])
  > forward :: Distance -> Task RobotInput RobotOutput ()
  > forward d = mkTask (proc i -> (roMake (setVelTR 0.2[m/s] 0), when (way >= d))) where
  >     way = integral (velocity i)
  > FROB
  $ frobc check bracket.frob
  error[E0205]: unknown name `i`
   --> bracket.frob:5:30
    |
  4 | forward d = mkTask (proc i -> (roMake (setVelTR 0.2[m/s] 0), when (way >= d))) where
    |                          - this `i` is a signal of the `proc`
  5 |     way = integral (velocity i)
    |                              ^
    |
    = hint: the bracket before this `where` ends the `proc`, so the equations after `where` cannot use the signals of the `proc`: move that bracket to the end of the last equation
  
  1 error
  [1]
  $ cat > comma.frob <<'FROB'
  > import Robot
  > main = reactimateTask spin
  > spin = mkTask (proc i -> roMake (setVelTR 0 1[rad/s]), edge (bumped i))
  > FROB
  $ frobc check comma.frob
  error[E0205]: unknown name `i`
   --> comma.frob:3:69
    |
  3 | spin = mkTask (proc i -> roMake (setVelTR 0 1[rad/s]), edge (bumped i))
    |                     -                                               ^
    |                     |
    |                     this `i` is a signal of the `proc`
    |
    = hint: the `proc` ends at the bracket or comma that follows it: use its signals only before that point, not in a later `where`
  
  1 error
  [1]
  $ cat > beside.frob <<'FROB'
  > main :: SF (Float, Float) (Float, Float)
  > main = (proc (a, b) -> s where s = a + b) &&& (proc (a, b) -> s - a)
  > FROB
  $ frobc check beside.frob
  error[E0205]: unknown name `s`
   --> beside.frob:2:63
    |
  2 | main = (proc (a, b) -> s where s = a + b) &&& (proc (a, b) -> s - a)
    |                                -                              ^
    |                                |
    |                                this `s` is a signal of the `proc`
    |
    = note: `s` is a unit: write it in brackets directly after a number, as in `3[s]`
    = hint: the `proc` ends at the bracket or comma that follows it: use its signals only before that point, not in a later `where`
  
  1 error
  [1]

There are no assignments, in any branch; use `case` to choose between constructors:

  $ cat > assigned.frob <<'FROB'
  > main :: SF (Velocity, Velocity) Velocity
  > main = proc (l, r) -> avg where
  >     avg = (l + r) / 2
  >     if avg > 1[m/s] then avg = 1[m/s]
  > FROB
  $ frobc check assigned.frob
  error[E0110]: expected `else` after the first branch, found `=`
   --> assigned.frob:4:30
    |
  4 |     if avg > 1[m/s] then avg = 1[m/s]
    |                              ^
    |
    = hint: Frob has no assignments: choose the value in one equation, as in `x = if c then a else b`
  
  1 error
  [1]
  $ cat > in_branches.frob <<'FROB'
  > main :: SF Bool Float
  > main = proc b -> v where
  >     if b then
  >         v = 1
  >     else
  >         v = 2
  > FROB
  $ frobc check in_branches.frob
  error[E0110]: expected `else` after the first branch, found `=`
   --> in_branches.frob:4:11
    |
  3 |     if b then
    |     -- this `if`
  4 |         v = 1
    |           ^
    |
    = hint: Frob has no assignments: choose the value in one equation, as in `x = if c then a else b`
  
  1 error
  [1]
  $ cat > match.frob <<'FROB'
  > data Mode = Idle | Run
  > main :: SF Mode Velocity
  > main = proc m -> v where
  >     v = match m with
  >         | Idle -> 0
  >         | Run -> 1[m/s]
  > FROB
  $ frobc check match.frob
  error[E0110]: expected an operator, an argument, or the end of this definition, found `|`
   --> match.frob:5:9
    |
  5 |         | Idle -> 0
    |         ^
    |
    = hint: use `case m of`, and write each branch on a line below it, as in `Idle -> …`
  
  1 error
  [1]
  $ cat > small.frob <<'FROB'
  > data Cmd = Go Velocity | Stop
  > main :: SF Cmd Velocity
  > main = proc c -> case c of
  >     stop -> 0
  >     Go v -> v
  > FROB
  $ frobc check small.frob
  warning[W0301]: this branch is never taken
   --> small.frob:5:5
    |
  4 |     stop -> 0
    |     ---- this starts with a lower-case letter, so it is a variable that matches any value
  5 |     Go v -> v
    |     ^^^^ the branches before it cover all its values
    |
    = hint: for the constructor, write `Stop`
  
  1 warning
  $ cat > bare.frob <<'FROB'
  > data Cmd = Go Velocity | Stop
  > main :: SF Cmd Velocity
  > main = proc c -> case c of
  >     Go -> 1[m/s]
  >     Stop -> 0
  > FROB
  $ frobc check bare.frob
  error[E0225]: constructor `Go` has 1 argument, not 0
   --> bare.frob:4:5
    |
  1 | data Cmd = Go Velocity | Stop
    |            -- declared here
  ...
  4 |     Go -> 1[m/s]
    |     ^^
    |
    = hint: its pattern is `Go a`: write `_` for an argument that you do not use
  
  1 error
  [1]

Records require constructors, and commas:

  $ cat > semicolon.frob <<'FROB'
  > data P = P { pos :: Distance; vel :: Velocity }
  > main :: SF P P
  > main = proc p -> p
  > FROB
  $ frobc check semicolon.frob
  error[E0111]: fields are separated by `,`, not by `;`
   --> semicolon.frob:1:29
    |
  1 | data P = P { pos :: Distance; vel :: Velocity }
    |                             ^
    |
    = hint: write `{ pos :: Distance, vel :: Velocity }`
  
  1 error
  [1]

However many such mistakes there are, other mistakes are still reported:

  $ cat > semicolons.frob <<'FROB'
  > data P = P
  >     { pos :: Distance;
  >       vel :: Velocity; on :: Bool
  >     }
  > data Q = Q { a :: Bool; b : Bool }
  > f x = x }
  > main :: SF P P
  > main = proc p -> p
  > FROB
  $ frobc check semicolons.frob 2>&1 | grep -A 3 '^error'
  error[E0111]: fields are separated by `,`, not by `;`
   --> semicolons.frob:2:22
    |
  2 |     { pos :: Distance;
  --
  error[E0111]: fields are separated by `,`, not by `;`
   --> semicolons.frob:5:23
    |
  5 | data Q = Q { a :: Bool; b : Bool }
  --
  error[E0103]: unexpected character `:`
   --> semicolons.frob:5:27
    |
  5 | data Q = Q { a :: Bool; b : Bool }
  --
  error[E0111]: this `}` has no opening bracket
   --> semicolons.frob:6:9
    |
  6 | f x = x }
  $ cat > alias.frob <<'FROB'
  > type P = { pos :: Distance, vel :: Velocity }
  > main :: SF P P
  > main = proc p -> p
  > FROB
  $ frobc check alias.frob
  error[E0110]: expected a type after `=`, found `{`
   --> alias.frob:1:10
    |
  1 | type P = { pos :: Distance, vel :: Velocity }
    |          ^
    |
    = hint: declare a record with `data` and a constructor: `data Pose = Pose { heading :: Angle }`
  
  1 error
  [1]
  $ cat > no_constructor.frob <<'FROB'
  > data Motor = Motor { left :: Velocity, right :: Velocity }
  > main :: SF Velocity Motor
  > main = proc v -> { left = v, right = v }
  > FROB
  $ frobc check no_constructor.frob
  error[E0110]: expected the output of this `proc`, or `do`, after `->`, found `{`
   --> no_constructor.frob:3:18
    |
  3 | main = proc v -> { left = v, right = v }
    |                  ^
    |
    = hint: put the constructor of the type before the braces, as in `Motor { left = v, right = v }`
  
  1 error
  [1]
  $ cat > no_field.frob <<'FROB'
  > import Geometry
  > main :: SF Point2 Distance
  > main = proc p -> p.z
  > FROB
  $ frobc check no_field.frob
  error[E0310]: `Vec2[m]` has no field `z`
   --> no_field.frob:3:20
    |
  3 | main = proc p -> p.z
    |                  - ^
    |                  |
    |                  this is `Vec2[m]`
    |
    = note: its fields: `x`, `y`
  
  1 error
  [1]

A type annotation belongs to its expression; names are not hidden; an hour:

  $ cat > annotation.frob <<'FROB'
  > import Control
  > main :: SF Float Float
  > main = proc x -> m where
  >     m = foldl (+) 0 xs / 4
  >     xs = window 0 x :: Array 4 Float
  > FROB
  $ frobc check annotation.frob
  error[E0110]: expected an operator, an argument, or the end of this definition, found `::`
   --> annotation.frob:5:21
    |
  5 |     xs = window 0 x :: Array 4 Float
    |                     ^^
    |
    = hint: put the expression and its type in parentheses: `(window 0 x :: Array 4 Float)`
  
  1 error
  [1]
  $ cat > hiding.frob <<'FROB'
  > import Control hiding (limit)
  > main :: SF Float Float
  > main = proc x -> x
  > FROB
  $ frobc check hiding.frob
  error[E0110]: expected `as`, a list of names in parentheses, or the end of the import, found `hiding`
   --> hiding.frob:1:16
    |
  1 | import Control hiding (limit)
    |                ^^^^^^
    |
    = hint: remove `hiding`: your own definitions hide imported ones, and two imports of the same name clash only if you use it
  
  1 error
  [1]
  $ cat > per_hour.frob <<'FROB'
  > main :: SF Velocity Float
  > main = proc v -> v / 1[km/h]
  > FROB
  $ frobc check per_hour.frob
  error[E0208]: unknown unit `h`
   --> per_hour.frob:2:27
    |
  2 | main = proc v -> v / 1[km/h]
    |                           ^
    |
    = hint: the unit is `hour`: write `1[km/hour]`
  
  1 error
  [1]

Arguments of a switch, components of a program, computations with arrays, and a position:

  $ cat > truth.frob <<'FROB'
  > main :: SF Distance Distance
  > main = switch start next where
  >     start = proc d -> (d, d > 1[m])
  >     next () = proc d -> 0
  > FROB
  $ frobc check truth.frob
  error[E0301]: expected `SF n[m] (n[m], Event a)`, found `SF n[m] (n[m], Bool)`
   --> truth.frob:2:15
    |
  2 | main = switch start next where
    |        ------ ^^^^^
    |        |
    |        argument 1 of `switch` is `SF n[m] (n[m], Event a)`
    |
    = hint: end the mode with an event: `edge b` occurs when `b` becomes True, `when b` whenever `b` is True
  
  1 error
  [1]
  $ cat > goes_on.frob <<'FROB'
  > main :: SF Distance Distance
  > main = switch start next where
  >     start = proc d -> (d, edge (d > 1[m]))
  >     next = proc d -> 0
  > FROB
  $ frobc check goes_on.frob
  error[E0304]: expected a function, found a signal function: `SF a n1[u]`
   --> goes_on.frob:2:21
    |
  2 | main = switch start next where
    |        ------       ^^^^
    |        |
    |        argument 2 of `switch` is `() -> SF n[m] n[m]`
    |
    = hint: write a function that ignores its argument: `(\_ -> next)`
  
  1 error
  [1]
  $ cat > task.frob <<'FROB'
  > import Robot
  > main = reactimateRobot spin
  > spin = do
  >     forward 1[m]
  >     forward 2[m]
  > forward d = sleepT (d / 0.2[m/s]) (roMake (setVelTR 0.2[m/s] 0))
  > FROB
  $ frobc check task.frob
  error[E0371]: expected a signal function, found a task
   --> task.frob:2:24
    |
  2 | main = reactimateRobot spin
    |        --------------- ^^^^ this is `Task c d ()`
    |        |
    |        argument 1 of `reactimateRobot` is `SF a b`
    |
    = hint: use `reactimateTask spin` to turn a task into a program
  
  1 error
  [1]
  $ cat > array.frob <<'FROB'
  > main :: SF (Array 4 Float) (Array 4 Float)
  > main = proc xs -> xs * 2
  > FROB
  $ frobc check array.frob
  error[E0301]: expected a number, found `Array 4 Float`
   --> array.frob:2:19
    |
  2 | main = proc xs -> xs * 2
    |                   ^^ - argument 1 of `*` is a number
    |
    = hint: use `map (\x -> x * 2) xs` to compute with each element
  
  1 error
  [1]
  $ cat > place.frob <<'FROB'
  > import Robot
  > main = reactimateTask (do
  >     driveTo 1 2)
  > FROB
  $ frobc check place.frob
  error[E0301]: expected `Point2`, found a number
   --> place.frob:3:13
    |
  3 |     driveTo 1 2)
    |     ------- ^
    |     |
    |     argument 1 of `driveTo` is `Point2`
    |
    = hint: write a vector with its field names: `Vec2 { x = 1[m], y = 2[m] }`, with `import Geometry`
  
  1 error
  [1]

Tasks side by side have two outputs, and a text is not an output:

  $ cat > race.frob <<'FROB'
  > import Robot
  > main = reactimateTask (race forward (sleepT 3[s] (roMake id)))
  > forward = sleepT 1[s] (roMake (setVelTR 0.2[m/s] 0))
  > FROB
  $ frobc check race.frob --robot pioneer
  error[E0360]: there is no instance `RobotOutput (b, c)`
    --> race.frob:2:8
     |
   2 | main = reactimateTask (race forward (sleepT 3[s] (roMake id)))
     |        ^^^^^^^^^^^^^^ `reactimateTask` needs it
     |
    ::: stdlib/Robot.frob:44:19
     |
  44 | reactimateTask :: RobotOutput o => Task i o c -> Program i o
     |                   ------------------------------------------ `reactimateTask` requires `RobotOutput o` here
     |
     = hint: `both` returns a pair of outputs: combine them with `mapOutput`, or use `timeOut` or `abortWhen`, which keep only the output of the task
  
  1 error
  [1]
  $ cat > label.frob <<'FROB'
  > main :: SF Bool (Float, String)
  > main = proc stopped -> (0, if stopped then "stopped" else "ready")
  > FROB
  $ frobc check label.frob
  error[E0412]: the output of `main` cannot be of type `(Float, String)`
   --> label.frob:2:1
    |
  2 | main = proc stopped -> (0, if stopped then "stopped" else "ready")
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: functions, signal functions and labels only exist at compile time
    = hint: to show names, declare a `data` type: `data State = Ready | Stopped`
  
  1 error
  [1]

A function without arguments is applied to `()`:

  $ cat > nothing.frob <<'FROB'
  > foreign seven :: () -> Int = "seven"
  > main :: SF () Int
  > main = proc () -> seven
  > FROB
  $ frobc check nothing.frob
  error[E0301]: expected `Int`, found the function `() -> Int`
   --> nothing.frob:3:19
    |
  2 | main :: SF () Int
    |         --------- the signature of `main` requires the output `Int`
  3 | main = proc () -> seven
    |                   ^^^^^
    |
    = hint: write `seven ()`
  
  1 error
  [1]
