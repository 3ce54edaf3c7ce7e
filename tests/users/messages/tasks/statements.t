Statements of a `do` that are not tasks, or not quite.

A missing argument: the type of the function shows which one.

  $ cat > sleep.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (do
  >     forward 1[m]
  >     sleepT 5[s]
  >     forward 1[m])
  > FROB
  $ frobc check sleep.frob
  error[E0301]: expected `Task a b c`, found the function `d -> Task e d ()`
   --> sleep.frob:5:5
    |
  3 | main = reactimateTask (do
    |        -------------- so each task of this `do` is `Task a b c`
  4 |     forward 1[m]
  5 |     sleepT 5[s]
    |     ^^^^^^^^^^^
    |
    = hint: `sleepT 5[s] restingOutput` waits with the robot at rest; any other output may stand there
  
  1 error
  [1]
  $ sed 's/sleepT 5.s./& restingOutput/' sleep.frob > cured.frob
  $ frobc check cured.frob

A task is not a condition; its result is.

  $ cat > condition.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (do
  >     if forward 1[m]
  >       then turnBy 90[deg]
  >       else turnBy (-90[deg]))
  > FROB
  $ frobc check condition.frob
  error[E0301]: a condition must be `Bool`, but this is `Task a b Bool`
   --> condition.frob:4:8
    |
  4 |     if forward 1[m]
    |        ^^^^^^^^^^^^
    |
    = hint: the task runs on a line before, which names its result: `ok <- forward 1[m]`, and here stands `ok`
  
  1 error
  [1]
  $ sed 's/    if forward/    ok <- forward/;s/      then/    if ok then/' condition.frob > cured.frob
  $ frobc check cured.frob

All branches must have the same result type:

  $ cat > branches.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (do
  >     ok <- forward 1[m]
  >     if ok
  >       then return True
  >       else sleepT 1[s] restingOutput)
  > FROB
  $ frobc check branches.frob
  error[E0301]: expected a task that ends with `Bool`, but this one ends with `()`
   --> branches.frob:7:12
    |
  6 |       then return True
    |            ----------- this branch is `Task a b Bool`
  7 |       else sleepT 1[s] restingOutput)
    |            ^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: in a `do`, `return x` below it ends the two with `x`
  
  1 error
  [1]
  $ sed 's/return True/return ()/' branches.frob > cured.frob
  $ frobc check cured.frob

Several tasks in a branch:

  $ cat > several.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (do
  >     ok <- forward 1[m]
  >     if ok
  >       then
  >         turnBy 90[deg]
  >         forward 1[m]
  >       else return True)
  > FROB
  $ frobc check several.frob
  error[E0302]: `turnBy` takes 1 argument, but is given more
   --> several.frob:8:9
    |
  7 |         turnBy 90[deg]
    |         ------ with one argument the result is `Task a b Bool`
  8 |         forward 1[m]
    |         ^^^^^^^ one too many
    |
    = hint: several tasks, one below the other, stand in a `do`, which opens their block
  
  1 error
  [1]
  $ sed 's/then$/then do/' several.frob > cured.frob
  $ frobc check cured.frob

A robot's command takes time:

  $ cat > output.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (do
  >     setVelTR 0.3[m/s] 0)
  > FROB
  $ frobc check output.frob
  error[E0370]: the statements of a `do` are tasks, but this is `d -> d`
   --> output.frob:4:5
    |
  3 | main = reactimateTask (do
    |        -------------- argument 1 of `reactimateTask` is `Task a b c`
  4 |     setVelTR 0.3[m/s] 0)
    |     ^^^^^^^^^^^^^^^^^^^
    |
    = hint: `sleepT 1[s] (roMake (setVelTR 0.3[m/s] 0))` is a task that does so for a second, `constT (roMake (setVelTR 0.3[m/s] 0))` one that never ends
  
  1 error
  [1]
  $ sed 's/setVel.* 0/sleepT 1[s] (roMake (&))/' output.frob > cured.frob
  $ frobc check cured.frob
