Signal functions and tasks that restart themselves: reported at the program's own place, with its
own names.

A task of the library runs first; the growing one is the program's.

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
  > main = reactimateTask (esc 0 (sleepT 30[s] restingOutput))
  > FROB
  $ frobc check tasks.frob
  error[E0416]: `esc` grows each time it restarts itself
   --> tasks.frob:6:5
    |
  6 |     if ok then return () else esc (n + 1) (twice t)
    |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ it restarts here, with one more `twice`
    |
    = note: frobc must know all tasks that can run, so their number must be finite
    = hint: restart it with the same tasks each time; only numbers may change
  
  warning[W0306]: `Geometry` is imported, but nothing from it is used
   --> tasks.frob:2:1
    |
  2 | import Geometry
    | ^^^^^^^^^^^^^^^
    |
    = hint: remove it
  
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
  > main = reactimateTask (search (sleepT 9[s] restingOutput))
  > FROB
  $ frobc check blocks.frob
  error[E0416]: `search` grows each time it restarts itself
   --> blocks.frob:7:9
    |
  5 |     search (do
    |     ----------
  6 |         forward 1[m]
  7 |         t)
    |         ^- `search` starts here, between two restarts
    |         |
    |         it restarts here, with one more `search`
    |
    = note: frobc must know all tasks that can run, so their number must be finite
    = hint: restart it with the same tasks each time; only numbers may change
  
  1 error
  [1]

`rSwitch` continues around the mode that restarts it.

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
  error[E0415]: `turn` restarts itself inside itself
   --> around.frob:7:5
    |
  3 | cruise = switch (proc i -> (roMake (setVelTR 0.2[m/s] 0), edge (frontSonar i < 0.5[m]))) (\_ -> turn)
    |                                                                                                 ---- `turn` restarts here
  ...
  7 |     o = rSwitch cruise (i, tag e cruise)
    |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ `turn` keeps running while the signal function here runs
    |
    = note: a signal function may only restart itself as the whole result of a continuation; otherwise each restart would need more memory
    = hint: use `switch`, which ends when its continuation starts; `rSwitch` never ends
  
  1 error
  [1]
