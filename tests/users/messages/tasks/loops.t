Tasks that may go round without time: named as the program names them.

A time that may be 0: it is the task with the time-out, not `timeOut`, that goes round.

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
  error[E0402]: `blink → blink` may go round for ever within one instant
   --> blink.frob:5:5
  5 |     forward 1[m] `timeOut` q
    |     ^^^^^^^^^^^^^^^^^^^^^^^^ this may end as soon as it starts
  6 |     blink q
    |     ------- `blink` may go on to itself at its own first instant
    = note: at an instant at which `blink` is left as soon as it starts, nothing waits for the next one
    = hint: a time of at least 1 ns makes it wait: `max 1[ms] q`
  
  1 error
  $ sed 's/`timeOut` q/`timeOut` max 1[ms] q/;s/max 1.ms. q/(&)/' blink.frob > cured.frob
  $ frobc check cured.frob

A task that may have nothing to do, for ever:

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
  error[E0402]: `look → forever → look` may go round for ever within one instant
   --> look.frob:3:24
    |
  3 | main = reactimateTask (forever look)
    |                        ^^^^^^^^^^^^ `look` may end at once, and `forever` goes on
    |
    = note: what ends as soon as it starts takes no time, as `return` and `snapT`: nothing here waits for the next instant
    = hint: put a task that takes time into the circle: `untilT (proc x -> (…, condition))` takes one instant at least, `sleepT 10[ms] …` 10 ms, each with its output in place of `…`
  
  1 error
  [1]
  $ sed 's/    whenT/    untilT (proc _ -> (restingOutput, True))\n    whenT/' look.frob > cured.frob
  $ frobc check cured.frob
