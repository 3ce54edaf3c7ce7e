A function among the arguments that should be applied to the following ones.

  $ cat > tasks.frob <<'FROB'
  > import Robot
  > main = reactimateTask (do
  >     forward 1[m]
  >     sleepT 2[s] roMake (setVelTR 0 0)
  >     forever turnBy 90[deg])
  > FROB
  $ frobc check tasks.frob
  error[E0302]: `sleepT` takes 2 arguments, but is given 3
   --> tasks.frob:4:25
    |
  4 |     sleepT 2[s] roMake (setVelTR 0 0)
    |     ------              ^^^^^^^^^^^^ one too many
    |     |
    |     with 2 arguments, its result is `Task a ((b -> b) -> b) ()`
    |
    = hint: put parentheses around the argument: `sleepT 2[s] (roMake (setVelTR 0 0))`
  
  error[E0301]: expected `Task a b c`, found the function `Angle -> Task d e Bool`
   --> tasks.frob:5:13
    |
  5 |     forever turnBy 90[deg])
    |     ------- ^^^^^^
    |     |
    |     argument 1 of `forever` is `Task a b c`
    |
    = hint: put parentheses around the argument: `forever (turnBy 90[deg])`
  
  2 errors
  [1]

  $ cat > forever.frob <<'FROB'
  > import Robot
  > main = reactimateTask (forever forward 1[m])
  > FROB
  $ frobc check forever.frob
  error[E0301]: expected `Task a b c`, found the function `Distance -> Task d e Bool`
   --> forever.frob:2:32
    |
  2 | main = reactimateTask (forever forward 1[m])
    |                        ------- ^^^^^^^
    |                        |
    |                        argument 1 of `forever` is `Task a b c`
    |
    = hint: put parentheses around the argument: `forever (forward 1[m])`
  
  1 error
  [1]

`return` does not run its argument:

  $ cat > turn.frob <<'FROB'
  > import Robot
  > t :: (HasOdometry i, DiffDrive o) => Task i o ()
  > t = do
  >     return turnBy 90[deg]
  > main = reactimateTask t
  > FROB
  $ frobc check turn.frob
  error[E0302]: `return` takes 1 argument, but is given 2
   --> turn.frob:4:19
    |
  4 |     return turnBy 90[deg]
    |     ------        ^^^^^^^ one too many
    |     |
    |     with one argument, its result is `Task a b (Angle -> Task c d Bool)`
    |
    = hint: to run a task, remove `return`: `turnBy 90[deg]`
  
  1 error
  [1]
