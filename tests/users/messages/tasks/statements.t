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
  error[E0301]: `sleepT` lacks its last argument, the output during that time
   --> sleep.frob:5:5
    |
  3 | main = reactimateTask (do
    |        -------------- each task of this `do` must be `Task a b c`
  4 |     forward 1[m]
  5 |     sleepT 5[s]
    |     ^^^^^^^^^^^
    |
    = hint: add an output: `sleepT 5[s] restingOutput` waits with the robot at rest
  
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
    = hint: run the task with `ok <- forward 1[m]` on the line before this one, and write `ok` here
  
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
  error[E0301]: expected a task that returns `Bool`, but this one returns `()`
   --> branches.frob:7:12
    |
  6 |       then return True
    |            ----------- this branch is `Task a b Bool`
  7 |       else sleepT 1[s] restingOutput)
    |            ^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: to return `x` instead, write a `do` with `return x` below the task
  
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
  error[E0302]: `turnBy` takes 1 argument, but is given 3
   --> several.frob:8:9
    |
  7 |         turnBy 90[deg]
    |         ------ with one argument, its result is `Task a b Bool`
  8 |         forward 1[m]
    |         ^^^^^^^ too many from here on
    |
    = hint: put `do` before a sequence of tasks
  
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
  error[E0370]: each statement in a `do` must be a task, but this is `d -> d`
   --> output.frob:4:5
    |
  3 | main = reactimateTask (do
    |        -------------- argument 1 of `reactimateTask` is `Task a b c`
  4 |     setVelTR 0.3[m/s] 0)
    |     ^^^^^^^^^^^^^^^^^^^
    |
    = hint: use `sleepT 1[s] (roMake (setVelTR 0.3[m/s] 0))` for a task of one second, or `constT (roMake (setVelTR 0.3[m/s] 0))` for one that never ends
  
  1 error
  [1]
  $ sed 's/setVel.* 0/sleepT 1[s] (roMake (&))/' output.frob > cured.frob
  $ frobc check cured.frob
