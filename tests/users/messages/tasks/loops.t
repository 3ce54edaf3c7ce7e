Tasks that may repeat without taking time: the message uses the program's names.

A time that may be 0: the task with the time-out repeats, not `timeOut`.

  $ cat > blink.frob <<'FROB'
  > import Robot
  > 
  > blink :: Time -> Task RobotInput RobotOutput ()
  > blink q = do
  >     forward 1[m] `timeOut` q
  >     blink q
  > 
  > main = reactimateTask (do
  >     i <- snapT
  >     blink (knob "period" 0 5[s] 1[s] i))
  > FROB
  $ frobc check blink.frob 2>&1 | grep -v -e Prelude -e "^ *[0-9]* |   where" -e "^ *|$"
  error[E0402]: `blink → blink` may repeat endlessly within one instant
   --> blink.frob:5:5
  5 |     forward 1[m] `timeOut` q
    |     ^^^^^^^^^^^^^^^^^^^^^^^^ this may end as soon as it starts
  6 |     blink q
    |     ------- `blink` may start itself again at its own first instant
    = note: no time passes between these steps when `blink` ends as soon as it starts
    = hint: make the wait at least 1 ns long, for example with `max 1[ms] q`
  
  1 error
  $ sed 's/`timeOut` q/`timeOut` max 1[ms] q/;s/max 1.ms. q/(&)/' blink.frob > cured.frob
  $ frobc check cured.frob

A task that may be empty, forever:

  $ cat > look.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (forever look)
  > 
  > look = do
  >     i <- snapT
  >     whenT (bumped i) (turnBy 90[deg])
  > FROB
  $ frobc check look.frob
  error[E0402]: `look → forever → look` may repeat endlessly within one instant
   --> look.frob:3:24
    |
  3 | main = reactimateTask (forever look)
    |                        ^^^^^^^^^^^^ `look` may end in its first instant, and `forever` follows it
    |
    = note: a task such as `return` or `snapT` takes no time, and no task in this loop waits for the next instant
    = hint: make the loop take time with a task: `untilT (proc x -> (…, condition))` takes at least one instant, and `sleepT 10[ms] …` takes 10 ms; replace `…` with the robot's output
  
  1 error
  [1]
  $ sed 's/    whenT/    untilT (proc _ -> (restingOutput, True))\n    whenT/' look.frob > cured.frob
  $ frobc check cured.frob
