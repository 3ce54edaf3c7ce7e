A threshold beyond the robot's sensor range: reported if the robot is known, from its types or from
the command line, also through an equation and `watching`.

  $ cat > far.frob <<'FROB'
  > import Robot
  > 
  > near = 0.6[m]
  > 
  > main :: (HasSonar i, DiffDrive o) => Program i o
  > main = reactimateTask (watching (mkTask (proc i -> (roMake (setVelTR v 0[1/s]), when free) where
  >     ahead = frontSonar i
  >     v = if ahead < near then 0[m/s] else 0.2[m/s]
  >     free = 0.5[m] < sideSonar i || ahead >= 0.5[m])))
  > FROB
  $ frobc check far.frob
  $ frobc check far.frob --robot pioneer
  $ frobc check far.frob --robot create
  warning[W0310]: this is always True: on a Create, `frontSonar` is at most 0.5 m
   --> far.frob:8:12
    |
  8 |     v = if ahead < near then 0[m/s] else 0.2[m/s]
    |            ^^^^^^^^^^^^
    |
    = note: when nothing is in range, the reading is `sonarReach i`
    = hint: compare the reading with a smaller distance
  
  warning[W0310]: this is always False: on a Create, `sideSonar` is at most 0.5 m
   --> far.frob:9:12
    |
  9 |     free = 0.5[m] < sideSonar i || ahead >= 0.5[m])))
    |            ^^^^^^^^^^^^^^^^^^^^
    |
    = note: when nothing is in range, the reading is `sonarReach i`
    = hint: compare the reading with a smaller distance
  
  2 warnings
  $ cat > typed.frob <<'FROB'
  > import Robot
  > 
  > main :: SF RobotInput Bool
  > main = proc i -> frontSonar i > 7[m] || frontSonar i > 2[m]
  > FROB
  $ frobc check typed.frob
  warning[W0310]: this is always False: on a Pioneer, `frontSonar` is at most 5 m
   --> typed.frob:4:18
    |
  4 | main = proc i -> frontSonar i > 7[m] || frontSonar i > 2[m]
    |                  ^^^^^^^^^^^^^^^^^^^
    |
    = note: when nothing is in range, the reading is `sonarReach i`
    = hint: compare the reading with a smaller distance
  
  1 warning
