Tasks with the statements of other languages.

  $ cat > return_eq.frob <<'FROB'
  > import Robot
  > slow x = return (x * 0.5)
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = slow 0.4[m/s])
  > FROB
  $ frobc check return_eq.frob
  error[E0301]: expected `Velocity` (m/s), found `Task a b Float[m/s]`
   --> return_eq.frob:3:52
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
    |                                           -------- ^
    |                                           |
    |                                           argument 1 of `setVelTR` is `Velocity` (m/s)
    |
    = hint: `return` is only for tasks: write the value after the `=`, without `return`
  
  1 error
  [1]

  $ cat > task_semis.frob <<'FROB'
  > import Robot
  > import Driving
  > main = reactimateTask (forward 1[m]; turnBy 90[deg])
  > FROB
  $ frobc check task_semis.frob
  error[E0111]: this `(` is never closed
   --> task_semis.frob:3:23
    |
  3 | main = reactimateTask (forward 1[m]; turnBy 90[deg])
    |                       ^            - a `)` is missing before this
    |
    = hint: a `;` ends a definition: write each task on its own line of a `do`
  
  1 error
  [1]

  $ cat > task_loop_while.frob <<'FROB'
  > import Robot
  > import Driving
  > main = reactimateTask square
  > square = do
  >     while True:
  >         forward 1[m]
  >         turnBy 90[deg]
  > FROB
  $ frobc check task_loop_while.frob
  error[E0103]: unexpected character `:`
   --> task_loop_while.frob:5:15
    |
  5 |     while True:
    |               ^
    |
    = hint: to repeat the tasks of this block, write `forever $ do` in place of this line
  
  1 error
  [1]

  $ cat > task_sleepT_noout.frob <<'FROB'
  > import Robot
  > import Driving
  > go = do
  >     forward 1[m]
  >     sleepT 2[s]
  >     forward 1[m]
  > main = reactimateTask go
  > FROB
  $ frobc check task_sleepT_noout.frob
  error[E0301]: `sleepT` lacks its last argument, the output during that time
   --> task_sleepT_noout.frob:5:5
    |
  4 |     forward 1[m]
    |     ------------ each task of this `do` must be `Task a b c`
  5 |     sleepT 2[s]
    |     ^^^^^^^^^^^
    |
    = hint: add an output: `sleepT 2[s] restingOutput` waits with the robot at rest
  
  1 error
  [1]

  $ cat > return_in_the_middle.frob <<'FROB'
  > import Robot
  > import Driving
  > t = do
  >     forward 1[m]
  >     return ()
  >     turnBy 90[deg]
  > main = reactimateTask t
  > FROB
  $ frobc check return_in_the_middle.frob
  warning[W0312]: this `return` has no effect: the statements after it still run
   --> return_in_the_middle.frob:5:5
    |
  5 |     return ()
    |     ^^^^^^^^^
    |
    = hint: remove it: a task ends after its last statement
  
  1 warning

  $ cat > early_return.frob <<'FROB'
  > import Robot
  > import Driving
  > t = do
  >     x <- snapT
  >     if place x == place x then return 5 else return 6
  >     return 5
  >     turnBy 90[deg]
  > main = reactimateTask t
  > FROB
  $ frobc check early_return.frob
  warning[W0312]: this does not end the task: the statements after it still run
   --> early_return.frob:5:5
    |
  5 |     if place x == place x then return 5 else return 6
    |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: move the remaining statements into the other branch: `if place x == place x then return 5 else do`
  
  warning[W0312]: this `return` has no effect: the statements after it still run
   --> early_return.frob:6:5
    |
  6 |     return 5
    |     ^^^^^^^^
    |
    = hint: remove it: a task ends after its last statement
  
  2 warnings

A `return` that does nothing is removed without confirmation.

  $ frobc fix return_in_the_middle.frob
  return_in_the_middle.frob:5:5: remove it (W0312)
  $ tail -5 return_in_the_middle.frob
  import Driving
  t = do
      forward 1[m]
      turnBy 90[deg]
  main = reactimateTask t

  $ cat > task_return_early.frob <<'FROB'
  > import Robot
  > import Driving
  > go :: Task RobotInput RobotOutput Bool
  > go = do
  >     b <- ask (arr bumped)
  >     if b then return False
  >     forward 1[m]
  > main = reactimateTask go
  > FROB
  $ frobc check task_return_early.frob
  error[E0110]: expected `else` after the first branch, found the end of the statement
   --> task_return_early.frob:6:27
    |
  6 |     if b then return False
    |                           ^
    |
    = hint: `return` does not end the task early: put the remaining statements into the other branch, below `else do`
  
  1 error
  [1]

  $ cat > task_parallel.frob <<'FROB'
  > import Robot
  > import Driving
  > main = reactimateTask (forward 1[m] || turnBy 90[deg])
  > FROB
  $ frobc check task_parallel.frob
  error[E0301]: expected `Bool`, found `Task a b Bool`
   --> task_parallel.frob:3:24
    |
  3 | main = reactimateTask (forward 1[m] || turnBy 90[deg])
    |                        ^^^^^^^^^^^^ -- argument 1 of `||` is `Bool`
    |
    = hint: use `both s t` to run two tasks in parallel, `abortWhen` to end a task at an event, or a `do` to run them one after the other
  
  1 error
  [1]
