Mistakes at a place other than the one whose types clash. Every replacement that a message offers
compiles when it is pasted.

The unit of a gain, in the argument of a limit that has the right unit:

  $ cat > limited.frob <<'FROB'
  > import Control
  > main :: SF Distance AngularVelocity
  > main = proc side -> limit 1[rad/s] (4[rad/s] * (0.5[m] - side))
  > FROB
  $ frobc check limited.frob
  error[E0320]: expected the unit `1/s`, found `m/s`
   --> limited.frob:3:37
    |
  3 | main = proc side -> limit 1[rad/s] (4[rad/s] * (0.5[m] - side))
    |                     ----- --------  ^^^^^^^^^^^^^^^^^^^^^^^^^^ this is `Float[m/s]`
    |                     |     |
    |                     |     because this is `Float[1/s]`
    |                     argument 2 of `limit` is `Float[1/s]`
    |
    = hint: if the gain `4[rad/s]` should have a different unit, write `4[rad/m/s]`
  
  1 error
  [1]
  $ sed 's/4\[rad\/s\]/4[rad\/m\/s]/' limited.frob > pasted.frob && frobc check pasted.frob

  $ cat > rate.frob <<'FROB'
  > import Control
  > main :: SF Distance AngularVelocity
  > main = proc side -> limit 1[rad/s] (4[rad/s] * derivative side)
  > FROB
  $ frobc check rate.frob
  error[E0320]: expected the unit `1/s`, found `m/s^2`
   --> rate.frob:3:37
    |
  3 | main = proc side -> limit 1[rad/s] (4[rad/s] * derivative side)
    |                     ----- --------  ^^^^^^^^^^^^^^^^^^^^^^^^^^ this is `Float[m/s^2]`
    |                     |     |
    |                     |     because this is `Float[1/s]`
    |                     argument 2 of `limit` is `Float[1/s]`
    |
    = hint: if the gain `4[rad/s]` should have a different unit, write `4[rad/m]`
  
  1 error
  [1]
  $ sed 's/4\[rad\/s\]/4[rad\/m]/' rate.frob > pasted.frob && frobc check pasted.frob

A task in place of a robot's output:

  $ cat > task.frob <<'FROB'
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (proc i -> forward 1[m])
  > FROB
  $ frobc check task.frob
  error[E0301]: expected the robot's output, found a task: `Task a b Bool`
   --> task.frob:3:35
    |
  2 | main :: Program RobotInput RobotOutput
    |         ------------------------------ the signature of `main` requires `Program RobotInput RobotOutput`
  3 | main = reactimateRobot (proc i -> forward 1[m])
    |                                   ^^^^^^^^^^^^
    |
    = hint: to run a task, write `reactimateTask (forward 1[m])`
  
  1 error
  [1]
  $ cat > pasted.frob <<'FROB'
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateTask (forward 1[m])
  > FROB
  $ frobc check pasted.frob

An event compared with a constructor of another type:

  $ cat > none.frob <<'FROB'
  > main :: SF (Event Distance) Bool
  > main = proc echo -> echo == None
  > FROB
  $ frobc check none.frob
  error[E0206]: unknown constructor `None`
   --> none.frob:2:29
    |
  2 | main = proc echo -> echo == None
    |                             ^^^^
    |
    = hint: for an event that does not occur, write `NoEvent`
  
  1 error
  [1]
  $ sed 's/None/Nothing/' none.frob > nothing.frob && frobc check nothing.frob
  error[E0301]: expected `Event Distance`, found `Maybe a`
   --> nothing.frob:2:29
    |
  2 | main = proc echo -> echo == Nothing
    |                     ----    ^^^^^^^
    |                     |
    |                     this is `Event Distance`
    |
    = hint: `Nothing` is a `Maybe`: for an event that does not occur, write `NoEvent`
  
  1 error
  [1]
  $ sed 's/None/NoEvent/' none.frob > pasted.frob && frobc check pasted.frob

A distance for a turn:

  $ cat > turn.frob <<'FROB'
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateTask (do
  >     turnBy 1[m]
  >     turnBy 90[deg])
  > FROB
  $ frobc check turn.frob
  error[E0320]: expected no unit, found `m`
   --> turn.frob:4:12
    |
  4 |     turnBy 1[m]
    |     ------ ^^^^ this is `Float[m]`
    |     |
    |     argument 1 of `turnBy` is `Angle` (1)
    |
    = hint: `turnBy` turns by an angle: to drive a distance, write `forward 1[m]`
  
  1 error
  [1]
  $ sed 's/turnBy 1\[m\]/forward 1[m]/' turn.frob > pasted.frob && frobc check pasted.frob

A time step for `derivative`:

  $ cat > step.frob <<'FROB'
  > main :: SF Distance Velocity
  > main = proc side -> derivative side 0.02[s]
  > FROB
  $ frobc check step.frob
  error[E0302]: `derivative` takes 1 argument, but is given 2
   --> step.frob:2:37
    |
  2 | main = proc side -> derivative side 0.02[s]
    |                     ----------      ^^^^^^^ one too many
    |                     |
    |                     with one argument, its result is `Float[m/s]`
    |
    = hint: remove `0.02[s]`, because `derivative` already divides by the time between two instants: write `derivative side`
  
  1 error
  [1]
  $ sed 's/ 0.02\[s\]//' step.frob > pasted.frob && frobc check pasted.frob

A comparison after a function between backquotes:

  $ cat > implied.frob <<'FROB'
  > import Past
  > main :: SF (Velocity, Distance) Velocity
  > main = proc (wanted, ahead) -> v where
  >     near = ahead < 0.3[m]
  >     v    = if near then 0 else min 0.5[m/s] wanted
  >     assert "stops for what is near" (near `implies` v == 0)
  > FROB
  $ frobc check implied.frob
  error[E0301]: expected `Bool`, found `Float[m/s]`
   --> implied.frob:6:53
    |
  6 |     assert "stops for what is near" (near `implies` v == 0)
    |                                           --------- ^
    |                                           |
    |                                           argument 2 of `implies` is `Bool`
    |
    = hint: put parentheses around the comparison: ``near `implies` (v == …)``
  
  1 error
  [1]
  $ sed 's/v == 0/(v == 0)/' implied.frob > pasted.frob && frobc check pasted.frob

The name of a type in lower case:

  $ cat > float.frob <<'FROB'
  > smaller :: float -> float -> float
  > smaller a b = if a < b then a else b
  > 
  > main :: SF (Float, Float) Float
  > main = proc (a, b) -> smaller a b
  > FROB
  $ frobc check float.frob
  error[E0309]: `<` needs `Ord float`, which the signature of `smaller` does not declare
   --> float.frob:2:20
    |
  1 | smaller :: float -> float -> float
    |            ----------------------- the signature of `smaller`
  2 | smaller a b = if a < b then a else b
    |                    ^
    |
    = hint: `float` is a type variable, because it starts with a lower-case letter: for the type, write `Float`
  
  1 error
  [1]
  $ sed 's/float/Float/g' float.frob > pasted.frob && frobc check pasted.frob

A task in an equation of a `proc`, and in a `do`:

  $ cat > turn.frob <<'FROB'
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot drive
  > drive :: SF RobotInput RobotOutput
  > drive = proc i -> roMake (setVelTR 0.3[m/s] omega) where
  >     omega = if bumped i then 0 else turnBy 90[deg]
  > FROB
  $ frobc check turn.frob 2>&1 | grep -e ^error -e hint
  error[E0301]: expected a number, found `Task a b Bool`
    = hint: a `proc` cannot run a task, because a task takes time: compute a value here, or run `turnBy 90[deg]` in a `do`, as in `main = reactimateTask (do …)`
  $ sed -e 's/= roMake.*/= out where/' -e 's/-> roMake.*/-> out where/' -e 's/omega = .*/out = if bumped i then turnBy 90[deg] else roMake (setVelTR 0.3[m\/s] 0)/' turn.frob > branch.frob
  $ frobc check branch.frob 2>&1 | grep -e ^error -e hint
  error[E0301]: expected `RobotOutput`, found `Task a b Bool`
    = hint: a `proc` cannot run a task, because a task takes time: compute a value here, or run the task in a `do`, as in `main = reactimateTask (do …)`
  error[E0371]: `roMake` does not return a task, but `Task a b Bool` is needed here
    = hint: a `proc` cannot run a task, because a task takes time: compute a value here, or run the task in a `do`, as in `main = reactimateTask (do …)`
  $ sed 's/turnBy 90.deg./0.5[rad\/s]/' turn.frob > pasted.frob && frobc check pasted.frob
  $ printf 'import Robot\nmain :: Program RobotInput RobotOutput\nmain = reactimateTask (do\n    turnBy 90[deg]\n    sleepT (if True then turnBy 90[deg] else 2[s]) restingOutput)\n' > do.frob
  $ frobc check do.frob 2>&1 | grep -e ^error -e hint
  error[E0301]: expected `Time` (s), found `Task a b Bool`
    = hint: in a `do`, run the task with `x <- turnBy 90[deg]` on the line before this one, and use `x` here
