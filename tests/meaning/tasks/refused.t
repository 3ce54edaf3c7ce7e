Tasks may be recursive only in tail position, and every cycle must take time.

  $ . ./trace.sh

A call that is not the last statement, with the statements that still wait for
it.

  $ cat > not_last.frob <<'EOF'
  > bug :: Float -> Task Float Float ()
  > bug goal = do
  >     sleepT 1[s] goal
  >     bug (goal + 1)
  >     sleepT 1[s] 0
  > 
  > main = runTask (bug 1)
  > EOF
  $ frobc check not_last.frob
  error[E0420]: a task restarts itself, but not as its last statement
   --> not_last.frob:4:5
    |
  4 |     bug (goal + 1)
    |     ^^^^^^^^^^^^^^ it restarts here
  5 |     sleepT 1[s] 0
    |     ------------- this waits for the restarted task to end
    |
    = note: each restart would leave one more statement waiting, but memory is fixed
    = hint: make `bug` the last statement, or move the waiting statements into the branch that ends the task; to repeat a task, write `repeatT 4 t` or `forever t`
  
  1 error
  [1]

A call inside a task that is still being watched.

  $ cat > watched.frob <<'EOF'
  > bug :: Float -> Task Float Float ()
  > bug goal = do
  >     sleepT 1[s] goal
  >     _ <- bug (goal + 1) `timeOut` 3[s]
  >     return ()
  > 
  > main = runTask (bug 1)
  > EOF
  $ frobc check watched.frob
  error[E0415]: `bug` restarts itself inside itself
   --> watched.frob:4:10
    |
  4 |     _ <- bug (goal + 1) `timeOut` 3[s]
    |          ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ here, inside `timeOut`
    |
    = note: a task may only restart itself as the last statement of its `do`, and nothing around that `do` may keep running; otherwise each restart would need more memory
    = hint: to repeat a task, write `repeatT 4 t`, `whileT condition t` or `forever t`, followed by the statements to run after all repetitions
  
  1 error
  [1]

A task that first calls itself, directly or through combinators: no time would
pass, and it would do nothing.

  $ cat > first.frob <<'EOF'
  > go :: Int -> Task Float Float ()
  > go n = do
  >     go (n + 1)
  >     return ()
  > 
  > main = runTask (go 1)
  > EOF
  $ frobc check first.frob
  error[E0410]: `go` calls itself
   --> first.frob:2:1
    |
  2 | go n = do
    | ^^^^^^^^^
  3 |     go (n + 1)
    |     -- `go` uses `go` here
  4 |     return ()
    |     ^^^^^^^^^
    |
    = note: a task may only restart itself as the last statement of a `do`, after a task that takes time
  
  1 error
  [1]

  $ cat > through.frob <<'EOF'
  > go :: Task Float Float ()
  > go = forever go
  > 
  > a, b :: Task Float Float ()
  > a = do
  >   sleepT 1[s] 2
  >   b
  > b = mapT id a
  > 
  > c, d :: Bool -> Task Float Float ()
  > c e = if e then sleepT 1[s] 2 else d e
  > d e = c (not e)
  > main = runTask (do
  >   a
  >   go
  >   c True)
  > EOF
  $ frobc check through.frob
  error[E0410]: `go` calls itself
   --> through.frob:2:1
    |
  2 | go = forever go
    | ^^^^^^^^^^^^^^^ `go` uses `go` here
    |
    = note: a task may only restart itself as the last statement of a `do`, after a task that takes time
  
  error[E0410]: `c` calls itself through other definitions
    --> through.frob:11:1
     |
  11 | c e = if e then sleepT 1[s] 2 else d e
     | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
     | |                                  |
     | |                                  `c` uses `d` here
     | `c → d → c`
  12 | d e = c (not e)
     |       - `d` uses `c` here
     |
     = note: a task may only restart itself as the last statement of a `do`, after a task that takes time
  
  2 errors
  [1]

A cycle that takes no time, with what makes each step possible: because tasks are known to end
immediately …

  $ cat > at_once.frob <<'EOF'
  > main :: SF Float (Either () Float)
  > main = runTask (forever snapT)
  > EOF
  $ frobc check at_once.frob 2>&1 | without_lines
  error[E0402]: `snapT → forever → snapT` may repeat endlessly within one instant
   --> at_once.frob:2:17
    |
  2 | main = runTask (forever snapT)
    |                 ^^^^^^^^^^^^^ `snapT` may end in its first instant, and `forever` follows it
    |
    = note: a task such as `return` or `snapT` takes no time, and no task in this loop waits for the next instant
    = hint: make the loop take time with a task: `untilT (proc x -> (…, condition))` takes at least one instant, and `sleepT 10[ms] …` takes 10 ms; replace `…` with the robot's output
  
  1 error

… because they are just `return` …

  $ cat > returns.frob <<'EOF'
  > go :: Int -> Task Float Float ()
  > go n = do
  >     m <- return (n + 1)
  >     other m
  > 
  > other :: Int -> Task Float Float ()
  > other m = do
  >    return ()
  >    go m
  > 
  > main = runTask (go 1)
  > EOF
  $ frobc check returns.frob
  error[E0402]: `go → go` may repeat endlessly within one instant
   --> returns.frob:3:10
    |
  3 |     m <- return (n + 1)
    |          ^^^^^^^^^^^^^^
  4 |     other m
    |     ------- `go` may start itself again at its own first instant
    |
    = note: no time passes between these steps when `go` ends as soon as it starts
    = note: frobc stopped after 1000 steps, the maximum for one instant, without finding an end
    = hint: use `untilT (proc x -> (…, condition))`, which ends when the condition is true but takes at least one instant; `edge` would wait forever if the condition were true from the start
  
  warning[W0312]: this `return` has no effect: the statements after it still run
   --> returns.frob:8:4
    |
  8 |    return ()
    |    ^^^^^^^^^
    |
    = hint: remove it: a task ends after its last statement
  
  1 error, 1 warning
  [1]

… or because a time may be 0; if the time is known to be positive, the program
is accepted.

  $ cat > may_be_none.frob <<'EOF'
  > main :: SF Float (Either Float ())
  > main = runTask t where
  >    t = do
  >       x <- snapT
  >       forever (sleepT (x * 1[s]) 2)
  > EOF
  $ frobc check may_be_none.frob 2>&1 | without_lines
  error[E0402]: `sleepT → forever → sleepT` may repeat endlessly within one instant
     --> may_be_none.frob:5:16
      |
    5 |       forever (sleepT (x * 1[s]) 2)
      |                ^^^^^^^^^^^^^^^^^^^ this may end as soon as it starts
      |
     ::: stdlib/Prelude.frob
      |
      |     forever t
      |     --------- `sleepT` may start itself again at its own first instant
      |
      = note: no time passes between these steps when `sleepT` ends as soon as it starts
      = hint: make the wait at least 1 ns long, for example with `max 1[ms] q`
  
  1 error
  $ sed 's/x \* 1\[s\]/max 1[ms] (x * 1[s])/' may_be_none.frob > is_some.frob
  $ frobc check is_some.frob

A condition that may be true from the start takes no time; the message shows the cycle. `untilT`
fixes it: it neither waits for a change nor stops.

  $ cat > corners.frob <<'EOF'
  > main :: SF Float (Either Float ())
  > main = runTask (forever (forEachT [1, 2] past))
  > 
  > past :: Float -> Task Float Float ()
  > past limit = mkTask (proc x -> (limit, when (x > limit)))
  > EOF
  $ frobc check corners.frob 2>&1 | without_lines
  error[E0402]: `past → forEachT → past` may repeat endlessly within one instant
     --> corners.frob:5:14
      |
    5 | past limit = mkTask (proc x -> (limit, when (x > limit)))
      |              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
      |                                        |
      |                                        `when` may occur at the first instant of `past`
      |
     ::: stdlib/Prelude.frob
      |
      |         forEachT (i + 1)
      |         ---------------- `past` may start itself again at its own first instant
      |
      = note: no time passes between these steps when `when` occurs as soon as `past` starts
      = hint: use `untilT (proc x -> (…, condition))`, which ends when the condition is true but takes at least one instant; `edge` would wait forever if the condition were true from the start
  
  1 error
  $ sed 's/mkTask (proc x -> (limit, when (x > limit)))/untilT (proc x -> (limit, x > limit))/' corners.frob > until.frob
  $ yes 3 | head -5 | rows in | trace until | cut -d, -f2 | xargs
  out Left 1 Left 2 Left 1 Left 2 Left 1

The message shows a task in a combinator of the library under the task's own name.

  $ cat > blink.frob <<'EOF'
  > main :: SF Float (Either Float ())
  > main = runTask (forever (blink `timeOut` 1[s]))
  > 
  > blink :: Task Float Float ()
  > blink = mkTask (proc x -> (1, when (x > 1)))
  > EOF
  $ frobc check blink.frob 2>&1 | without_lines
  error[E0402]: `blink → forever → blink` may repeat endlessly within one instant
     --> blink.frob:2:26
      |
    2 | main = runTask (forever (blink `timeOut` 1[s]))
      |                          ^^^^^^^^^^^^^^^^^^^^
  ...
    5 | blink = mkTask (proc x -> (1, when (x > 1)))
      |         ------------------------------------ `blink` may end at its first instant
      |
     ::: stdlib/Prelude.frob
      |
      |     forever t
      |     --------- `blink` may start itself again at its own first instant
      |
      = note: no time passes between these steps when `blink` ends as soon as it starts
      = hint: use `untilT (proc x -> (…, condition))`, which ends when the condition is true but takes at least one instant; `edge` would wait forever if the condition were true from the start
  
  1 error

A task that is written in the combinator's argument has the name of the definition that contains
both.

  $ cat > within.frob <<'EOF'
  > main :: SF Float (Either Float ())
  > main = runTask (forever blink)
  > 
  > blink :: Task Float Float (Maybe ())
  > blink = timeOut (whenT False (sleepT 1[s] 1)) 1[s]
  > EOF
  $ frobc check within.frob 2>&1 | without_lines
  error[E0402]: `blink → forever → blink` may repeat endlessly within one instant
     --> within.frob:5:9
      |
    5 | blink = timeOut (whenT False (sleepT 1[s] 1)) 1[s]
      |         ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
      |                  |
      |                  `blink` may end at its first instant
      |
     ::: stdlib/Prelude.frob
      |
      |     forever t
      |     --------- `blink` may start itself again at its own first instant
      |
      = note: no time passes between these steps when `blink` ends as soon as it starts
      = hint: use `untilT (proc x -> (…, condition))`, which ends when the condition is true but takes at least one instant; `edge` would wait forever if the condition were true from the start
  
  1 error

Parameters that grow.

  $ cat > grows.frob <<'EOF'
  > pingpong :: Task Float Float () -> Task Float Float ()
  > pingpong t = do
  >    t
  >    pingpong (t `withSF` time `mapTo` ())
  > mapTo t x = mapT (\_ -> x) t
  > main = runTask (pingpong (sleepT 1[s] 3))
  > EOF
  $ frobc check grows.frob
  error[E0416]: `pingpong` grows each time it restarts itself
   --> grows.frob:4:4
    |
  4 |    pingpong (t `withSF` time `mapTo` ())
    |    ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ it restarts here, with one more `withSF`
    |
    = note: frobc must know all tasks that can run, so their number must be finite
    = hint: restart it with the same tasks each time; only numbers may change
  
  1 error
  [1]


A cycle that the library closes, and that contains a task of the library, is shown at the place in
the program that calls it, with the part that takes time.

  $ cat > tour.frob <<'FROB'
  > import Geometry
  > import Robot
  > 
  > main = reactimateTask (tour 3)
  > 
  > tour :: (HasSonar i, DiffDrive o) => Int -> Task i o ()
  > tour n = do
  >     driveTo (Vec2 1[m] (toFloat n * 1[m]))
  >     tour (n - 1)
  > FROB
  $ frobc check tour.frob --robot pioneer 2>&1 | sed 's/frob:[0-9]*:\([0-9]*\)$/frob:N:\1/; s/^ *[0-9]* |/  N |/'
  error[E0402]: `driveTo → tour → driveTo` may repeat endlessly within one instant
    --> tour.frob:N:5
    N |
    N |     tour (n - 1)
    N |     ^^^^^^^^^^^^ `driveTo` may start itself again at its own first instant
    N |
    ::: stdlib/Driving.frob:N:5
    N |
    N |     arrived = atPlace goal i
    N |     ------------------------ `atPlace` may occur at the first instant of `driveTo`
    N |
     = note: no time passes between these steps when `atPlace` occurs as soon as `driveTo` starts
     = note: frobc stopped after 1000 steps, the maximum for one instant, without finding an end
     = hint: make the loop take time: add a task such as `sleepT 10[ms] restingOutput`, where `restingOutput` is the output of a robot at rest
  
  1 error
  $ cat > places.frob <<'FROB'
  > import Geometry
  > import Robot
  > 
  > main = reactimateTask (forever (forEachT [Vec2 1[m] 2[m], zeroVec] driveTo))
  > FROB
  $ frobc check places.frob --robot pioneer 2>&1 | sed 's/frob:[0-9]*:\([0-9]*\)$/frob:N:\1/; s/^ *[0-9]* |/  N |/'
  error[E0402]: `driveTo → forEachT → driveTo` may repeat endlessly within one instant
     --> places.frob:N:1
    N |
    N | main = reactimateTask (forever (forEachT [Vec2 1[m] 2[m], zeroVec] driveTo))
    N | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    N |
     ::: stdlib/Driving.frob:N:5
    N |
    N |     arrived = atPlace goal i
    N |     ------------------------ `atPlace` may occur at the first instant of `driveTo`
    N |
     ::: stdlib/Prelude.frob:N:9
    N |
    N |         forEachT (i + 1)
    N |         ---------------- `driveTo` may start itself again at its own first instant
    N |
      = note: no time passes between these steps when `atPlace` occurs as soon as `driveTo` starts
      = hint: make the loop take time: add a task such as `sleepT 10[ms] restingOutput`, where `restingOutput` is the output of a robot at rest
  
  1 error
  $ sed 's/driveTo)/visit)/' places.frob > visits.frob
  $ cat >> visits.frob <<'FROB'
  > 
  > visit p = do
  >     driveTo p
  >     sleepT 10[ms] restingOutput
  > FROB
  $ frobc check visits.frob --robot pioneer
