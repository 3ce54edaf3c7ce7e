Results of tasks, used as something else.

`()` is not a Bool:

  $ cat > nothing.frob <<'FROB'
  > import Robot
  > 
  > patrol = do
  >     ok <- sleepT 1[s] restingOutput
  >     if ok then forward 1[m] else return False
  > 
  > main = reactimateTask patrol
  > FROB
  $ frobc check nothing.frob
  error[E0301]: a condition must be `Bool`, but this is `()`
   --> nothing.frob:5:8
    |
  4 |     ok <- sleepT 1[s] restingOutput
    |     -- `ok` is bound here
  5 |     if ok then forward 1[m] else return False
    |        ^^
    |
    = hint: `()` carries no information: write a condition, such as `x > 0`
  
  1 error
  [1]

A task that may time out:

  $ cat > late.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (do
  >     ok <- forward 3[m] `timeOut` 5[s]
  >     if ok then turnBy 90[deg] else return False)
  > FROB
  $ frobc check late.frob
  error[E0301]: a condition must be `Bool`, but this is `Maybe Bool`
   --> late.frob:5:8
    |
  4 |     ok <- forward 3[m] `timeOut` 5[s]
    |     -- `ok` is bound here
  5 |     if ok then turnBy 90[deg] else return False)
    |        ^^
    |
    = hint: use `fromMaybe False ok`, which is False for `Nothing`, for example after a timeout
  
  1 error
  [1]
  $ sed 's/if ok/if fromMaybe False ok/' late.frob > cured.frob
  $ frobc check cured.frob

An event instead of a Bool:

  $ cat > event.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (do
  >     i <- snapT
  >     whenT (keyPressed i) (turnBy 90[deg])
  >     sleepT 1[s] restingOutput)
  > FROB
  $ frobc check event.frob
  error[E0301]: expected `Bool`, found `Event Int`
   --> event.frob:5:12
    |
  5 |     whenT (keyPressed i) (turnBy 90[deg])
    |     -----  ^^^^^^^^^^^^
    |     |
    |     argument 1 of `whenT` is `Bool`
    |
    = hint: use `isEvent (keyPressed i)`, which is True when the event occurs
  
  1 error
  [1]
  $ sed 's/(keyPressed i)/(isEvent (keyPressed i))/' event.frob > cured.frob
  $ frobc check cured.frob

A condition without the output that belongs to it:

  $ cat > until.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (untilT (proc i -> bumped i))
  > FROB
  $ frobc check until.frob
  error[E0301]: expected `(a, Bool)`, found `Bool`
   --> until.frob:3:42
    |
  3 | main = reactimateTask (untilT (proc i -> bumped i))
    |                        ------            ^^^^^^^^
    |                        |
    |                        argument 1 of `untilT` has the output `(a, Bool)`
    |
    = hint: write the output and the event as a pair: `(output, bumped i)`
  
  1 error
  [1]
  $ sed 's/bumped i/(restingOutput, &)/' until.frob > cured.frob
  $ frobc check cured.frob
