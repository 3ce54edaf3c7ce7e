Of the ways in which a task can continue, a later one is considered only if no earlier one fires,
and only with the results that are then possible. A time-out of 20 s does not end at the first
instant, so here a task that ends immediately is followed by one that takes time.

  $ cat > visit.frob <<'FROB'
  > import Geometry
  > import Robot
  > 
  > visit :: (HasSonar i, DiffDrive o) => Point2 -> Task i o ()
  > visit goal = do
  >     r <- driveTo goal `timeOut` 20[s]
  >     case r of
  >         Just True -> sleepT 2[s] (roMake (setVelTR 0 1[1/s]))
  >         Just False -> sleepT 1[s] (roMake (setVelTR (-0.1[m/s]) 0))
  >         Nothing -> return ()
  > 
  > patrol :: (HasSonar i, DiffDrive o) => Task i o ()
  > patrol = do
  >     visit Vec2 { x = 3[m], y = 0 }
  >     visit zeroVec
  >     patrol
  > 
  > main = reactimateTask (watching patrol)
  > FROB
  $ frobc check visit.frob
  $ frobc check --lint visit.frob

With a choice that takes no time, the task may repeat endlessly if the robot starts at its goal, or
if the time-out may be 0.

  $ sed 's/Just True -> .*/Just True -> return ()/' visit.frob > at_once.frob
  $ frobc check at_once.frob 2>&1 | grep -v '^ *|* *$'
  error[E0402]: `timeOut → visit → timeOut` may repeat endlessly within one instant
    --> at_once.frob:6:10
   6 |     r <- driveTo goal `timeOut` 20[s]
     |          ^^^^^^^^^^^^^^^^^^^^^^^^^^^^
   7 |     case r of
     |     ---------
  ...
  10 |         Nothing -> return ()
     |         -------------------- `timeOut` may start itself again at its own first instant
    ::: stdlib/Driving.frob:79:16
  79 | driveTo goal = mkTask (proc i ->
     |                -----------------
  ...
  91 |     blocked = when (looks && inTheWay || stuck i))
     |     ---------------------------------------------- `driveTo` may occur at the first instant of `timeOut`
     = note: no time passes between these steps when `driveTo` occurs as soon as `timeOut` starts
     = hint: make the loop take time: add a task such as `sleepT 10[ms] restingOutput`, where `restingOutput` is the output of a robot at rest
  1 error
  $ sed 's/20\[s\]/0[s]/' visit.frob > no_time.frob
  $ frobc check no_time.frob 2>&1 | grep -v '^ *|* *$'
  error[E0402]: `visit → visit` may repeat endlessly within one instant
    --> no_time.frob:6:10
   6 |     r <- driveTo goal `timeOut` 0[s]
     |          ^^^^^^^^^^^^^^^^^^^^^^^^^^^ this may end as soon as it starts
   7 |     case r of
     |     ---------
  ...
  10 |         Nothing -> return ()
     |         -------------------- `visit` may start itself again at its own first instant
     = note: no time passes between these steps when `visit` ends as soon as it starts
     = hint: make the wait at least 1 ns long, for example with `max 1[ms] q`
  1 error

Both engines agree if the task does end at its first instant.

  $ cat > ended.frob <<'FROB'
  > step :: Task Int Int ()
  > step = do
  >     r <- mkTask (proc n -> (n, mergeE (tag (when (n == 1)) True) (tag (when (n == 2)) False))) `timeOut` 2[s]
  >     case r of
  >         Just True -> sleepT 1[s] 100
  >         Just False -> sleepT 1[s] 200
  >         Nothing -> return ()
  > 
  > main :: SF Int (Either Int ())
  > main = runTask (forever step)
  > FROB
  $ printf 'time,in\n0,1\n1,2\n2,0\n3,0\n4,0\n5,2\n5.5,2\n6,1\n7,0\n' > in.csv
  $ frobc trace ended.frob --input in.csv
  time,out
  0.000000000,Left 100
  1.000000000,Left 200
  2.000000000,Left 0
  3.000000000,Left 0
  4.000000000,Left 0
  5.000000000,Left 200
  5.500000000,Left 200
  6.000000000,Left 100
  7.000000000,Left 0
  $ frobc trace ended.frob --input in.csv > c.csv
  $ frobc trace ended.frob --input in.csv --engine interp | diff - c.csv
