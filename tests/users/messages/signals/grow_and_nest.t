Signal functions and tasks that start themselves again: told at the program's own place, with its own names.

A task of the library runs first; what grows is the program's.

  $ cat > tasks.frob <<'FROB'
  > import Robot
  > import Geometry
  > esc :: (HasSonar i, HasOdometry i, DiffDrive o) => Int -> Task i o () -> Task i o ()
  > esc n t = do
  >     ok <- forward 1[m]
  >     if ok then return () else esc (n + 1) (twice t)
  > twice :: Task i o () -> Task i o ()
  > twice t = do
  >     t
  >     t
  > main = reactimateTask (esc 0 (turnBy 30[deg]))
  > FROB
  $ frobc check tasks.frob
  warning[W0306]: nothing of `Geometry` is used here
   --> tasks.frob:2:1
    |
  2 | import Geometry
    | ^^^^^^^^^^^^^^^
    |
    = hint: take it out
  
  error[E0416]: `esc` grows each time it starts itself again
   --> tasks.frob:6:5
    |
  6 |     if ok then return () else esc (n + 1) (twice t)
    |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ here, with one more `twice`
    |
    = note: which tasks can run must be known, and be finitely many
    = hint: start it with the same tasks each time; numbers may change
  
  1 error, 1 warning
  [1]

  $ cat > blocks.frob <<'FROB'
  > import Robot
  > search :: (HasSonar i, HasOdometry i, DiffDrive o) => Task i o () -> Task i o ()
  > search t = do
  >     t
  >     search (do
  >         forward 1[m]
  >         t)
  > main = reactimateTask (search (turnBy 90[deg]))
  > FROB
  $ frobc check blocks.frob
  error[E0416]: `search` grows each time it starts itself again
   --> blocks.frob:7:9
    |
  5 |     search (do
    |     ----------
  6 |         forward 1[m]
  7 |         t)
    |         ^- on the way `search` starts here
    |         |
    |         here, with one more `search`
    |
    = note: which tasks can run must be known, and be finitely many
    = hint: start it with the same tasks each time; numbers may change
  
  1 error
  [1]

`rSwitch` goes on around the mode that starts it again.

  $ cat > around.frob <<'FROB'
  > import Robot
  > cruise :: (HasSonar i, DiffDrive o) => SF i o
  > cruise = switch (proc i -> (roMake (setVelTR 0.2[m/s] 0), edge (frontSonar i < 0.5[m]))) (\_ -> turn)
  > turn :: (HasSonar i, DiffDrive o) => SF i o
  > turn = proc i -> o where
  >     e = edge (frontSonar i > 1[m])
  >     o = rSwitch cruise (i, tag e cruise)
  > main = reactimateRobot cruise
  > FROB
  $ frobc check around.frob
  error[E0415]: `turn` would run inside itself
   --> around.frob:7:5
    |
  3 | cruise = switch (proc i -> (roMake (setVelTR 0.2[m/s] 0), edge (frontSonar i < 0.5[m]))) (\_ -> turn)
    |                                                                                                 ---- here `turn` starts again
  ...
  7 |     o = rSwitch cruise (i, tag e cruise)
    |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ `turn` goes on around what runs here
    |
    = note: a signal function may start itself again only as the whole result of a continuation: then it takes no room
    = hint: `rSwitch` goes on for ever; `switch` ends, and what its continuation gives takes its place
  
  1 error
  [1]
