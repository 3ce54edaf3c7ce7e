A component of the expected type: the message shows how to construct the whole.

  $ cat > mark.frob <<'FROB'
  > import Display
  > import Geometry
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.1[m/s] 0 . draw (Circle (place i) 0.1[m])))
  > FROB
  $ frobc check mark.frob
  error[E0301]: expected `Mark`, found `Shape[m]`
   --> mark.frob:5:71
    |
  5 | main = reactimateRobot (proc i -> roMake (setVelTR 0.1[m/s] 0 . draw (Circle (place i) 0.1[m])))
    |                                                                 ----  ^^^^^^^^^^^^^^^^^^^^^^^
    |                                                                 |
    |                                                                 argument 1 of `draw` is `Mark`
    |
    = hint: use `InWorld colour …` or `OnRobot colour …` to convert this value
  
  1 error
  [1]
  $ sed 's/(Circle (place i) 0.1.m.)/(InWorld Red &)/;s/import Geometry//' mark.frob > cured.frob
  $ frobc check cured.frob

  $ cat > sonar.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (do
  >     d <- frontSonar
  >     if d > 1[m] then forward 0.5[m] else return False)
  > FROB
  $ frobc check sonar.frob
  error[E0371]: expected a task, found a signal function
   --> sonar.frob:4:10
    |
  3 | main = reactimateTask (do
    |        -------------- each task of this `do` must be `Task a b c`
  4 |     d <- frontSonar
    |          ^^^^^^^^^^ this is `SF d Distance`
    |
    = hint: to read it once, write `ask frontSonar`
    = hint: to run it for a fixed time, write `mkTask (frontSonar &&& after 5[s])`; to run it forever, `mkTask (frontSonar &&& never)`
  
  1 error
  [1]
  $ sed 's/<- frontSonar/<- ask frontSonar/' sonar.frob > cured.frob
  $ frobc check cured.frob

A name that has only a signature is reported once:

  $ cat > alone.frob <<'FROB'
  > import Robot
  > 
  > drive :: SF RobotInput RobotOutput
  > driv = proc _ -> roMake (setVelTR 0.3[m/s] 0)
  > 
  > main = reactimateRobot drive
  > FROB
  $ frobc check alone.frob
  error[E0214]: `drive` has a signature but no definition
   --> alone.frob:3:1
    |
  3 | drive :: SF RobotInput RobotOutput
    | ^^^^^
    |
    = hint: did you mean `driv`?
  
  1 error
  [1]
  $ sed 's/^driv /drive /' alone.frob > cured.frob
  $ frobc check cured.frob
