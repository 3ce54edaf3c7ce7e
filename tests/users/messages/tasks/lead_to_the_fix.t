Tasks and their results. Every replacement that a message offers compiles when it is pasted.

A task that `let` names but does not run:

  $ cat > named.frob <<'FROB'
  > import Robot
  > errand :: (HasSonar i, DiffDrive o) => Task i o Bool
  > errand = do
  >     let ok = forward 1[m]
  >     if ok then turnBy 90[deg] else turnBy (-90[deg])
  > main = reactimateTask (watching errand)
  > FROB
  $ frobc check named.frob
  error[E0301]: a condition must be `Bool`, but this is `Task a b Bool`
   --> named.frob:5:8
    |
  4 |     let ok = forward 1[m]
    |         -- `ok` is bound here
  5 |     if ok then turnBy 90[deg] else turnBy (-90[deg])
    |        ^^
    |
    = hint: run the task: write `ok <- forward 1[m]` in place of `let ok = forward 1[m]`
  
  1 error
  [1]
  $ sed 's:let ok = forward:ok <- forward:' named.frob > pasted.frob && frobc check pasted.frob

A branch without a result:

  $ cat > result.frob <<'FROB'
  > import Robot
  > errand :: (HasSonar i, DiffDrive o) => Task i o Bool
  > errand = do
  >     ok <- forward 1[m]
  >     if ok then return () else turnBy 90[deg]
  > main = reactimateTask (watching errand)
  > FROB
  $ frobc check result.frob
  error[E0301]: expected a task that returns `Bool`, but this one returns `()`
   --> result.frob:5:16
    |
  2 | errand :: (HasSonar i, DiffDrive o) => Task i o Bool
    |            ----------------------------------------- the signature of `errand` requires `Task i o Bool`
  ...
  5 |     if ok then return () else turnBy 90[deg]
    |                ^^^^^^^^^
    |
    = hint: return a `Bool` here: `return True` or `return False`
  
  1 error
  [1]
  $ sed 's:return ():return True:' result.frob > pasted.frob && frobc check pasted.frob

A pause without an output:

  $ cat > pause.frob <<'FROB'
  > import Robot
  > main = reactimateTask (watching (do
  >     forward 1[m]
  >     sleepT 2[s]
  >     turnBy 90[deg]))
  > FROB
  $ frobc check pause.frob
  error[E0301]: `sleepT` lacks its last argument, the output during that time
   --> pause.frob:4:5
    |
  2 | main = reactimateTask (watching (do
    |                        -------- each task of this `do` must be `Task (Watched a) b c`
  3 |     forward 1[m]
  4 |     sleepT 2[s]
    |     ^^^^^^^^^^^
    |
    = hint: add an output: `sleepT 2[s] restingOutput` waits with the robot at rest
  
  1 error
  [1]
  $ sed 's:sleepT 2\[s\]:sleepT 2[s] restingOutput:' pause.frob > pasted.frob && frobc check pasted.frob

A patrol that may never pause:

  $ cat > patrol.frob <<'FROB'
  > import Geometry
  > import Robot
  > patrol :: (HasSonar i, DiffDrive o) => Task i o ()
  > patrol = do
  >     driveTo (Vec2 { x = 1[m], y = 0 })
  >     driveTo zeroVec
  >     patrol
  > main = reactimateTask (watching patrol)
  > FROB
  $ frobc check patrol.frob
  error[E0402]: `driveTo → patrol → driveTo` may repeat endlessly within one instant
    --> patrol.frob:6:5
     |
   6 |     driveTo zeroVec
     |     ^^^^^^^^^^^^^^^ `driveTo` may start itself again at its own first instant
   7 |     patrol
     |     ------ and again here
     |
    ::: stdlib/Driving.frob:89:5
     |
  89 |     arrived = atPlace goal i
     |     ------------------------ `atPlace` may occur at the first instant of `driveTo`
     |
     = note: no time passes between these steps when `atPlace` occurs as soon as `driveTo` starts
     = hint: make the loop take time: add a task such as `sleepT 10[ms] restingOutput`, where `restingOutput` is the output of a robot at rest
  
  1 error
  [1]
  $ sed 's:    patrol:    sleepT 10[ms] restingOutput\n&:' patrol.frob > pasted.frob && frobc check pasted.frob

Counted loops:

  $ cat > counted.frob <<'FROB'
  > import Robot
  > mission = do
  >     for i in range(4):
  >         forward 1[m]
  >         turnBy 90[deg]
  > main = reactimateTask (watching mission)
  > FROB
  $ frobc check counted.frob
  error[E0103]: unexpected character `:`
   --> counted.frob:3:22
    |
  3 |     for i in range(4):
    |                      ^
    |
    = hint: to run the tasks of this block 4 times, write `repeatT 4 $ do` in place of this line
  
  1 error
  [1]
  $ sed 's:for i.*:repeatT 4 $ do:' counted.frob > pasted.frob && frobc check pasted.frob

  $ cat > counted_in_c.frob <<'FROB'
  > import Robot
  > mission = do
  >     for i in 1..4 do
  >         forward 1[m]
  >         turnBy 90[deg]
  > main = reactimateTask (watching mission)
  > FROB
  $ frobc check counted_in_c.frob
  error[E0110]: Frob has no `for`
   --> counted_in_c.frob:3:5
    |
  3 |     for i in 1..4 do
    |     ^^^
    |
    = hint: to run the tasks of this block 4 times, write `repeatT 4 $ do` in place of this line
  
  1 error
  [1]
  $ sed 's:for i.*:repeatT 4 $ do:' counted_in_c.frob > pasted.frob && frobc check pasted.frob

Tasks in an array:

  $ cat > array.frob <<'FROB'
  > import Robot
  > mission = [forward 1[m], turnBy 90[deg]]
  > main = reactimateTask (watching mission)
  > FROB
  $ frobc check array.frob
  error[E0301]: expected `Task (Watched a) b c`, found `Array 2 (Task d e Bool)`
   --> array.frob:3:33
    |
  3 | main = reactimateTask (watching mission)
    |                        -------- ^^^^^^^
    |                        |
    |                        argument 1 of `watching` is `Task (Watched a) b c`
    |
    = hint: to run tasks one after the other, write each task on its own line below a `do`: `forward 1[m]`, `turnBy 90[deg]`
  
  1 error
  [1]
  $ sed 's:\[forward 1.m., turnBy 90.deg..:do\n    forward 1[m]\n    turnBy 90[deg]:' array.frob > pasted.frob && frobc check pasted.frob
