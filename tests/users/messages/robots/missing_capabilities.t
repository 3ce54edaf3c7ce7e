A capability that the robot of a signature lacks: the hint changes all signatures and names a robot
that has the capability.

  $ cat > cliff.frob <<'FROB'
  > import Robot
  > 
  > careful :: SF RobotInput RobotOutput
  > careful = proc i -> roMake (setVelTR v 0) where
  >     v = if cliffAhead i then 0 else 0.2[m/s]
  > 
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot careful
  > FROB
  $ frobc check cliff.frob
  error[E0360]: a Pioneer does not have the capability `HasCliffs`, which `cliffAhead` needs
     --> cliff.frob:5:12
      |
    5 |     v = if cliffAhead i then 0 else 0.2[m/s]
      |            ^^^^^^^^^^ `cliffAhead` needs it
      |
     ::: stdlib/Capability.frob:104:15
      |
  104 | cliffAhead :: HasCliffs i => i -> Bool
      |               ------------------------ `cliffAhead` requires `HasCliffs i` here
      |
      = note: `RobotInput` is the input of a Pioneer
      = note: robots with `HasCliffs`: Create
      = hint: for such a robot, write `careful :: (HasCliffs i, DiffDrive o) => SF i o` and `main :: (HasCliffs i, DiffDrive o) => Program i o`, and compile with `--robot create`
  
  1 error
  [1]
  $ sed 's/:: SF.*/:: (HasCliffs i, DiffDrive o) => SF i o/;s/:: Program.*/:: (HasCliffs i, DiffDrive o) => Program i o/' cliff.frob > cured.frob
  $ frobc check --robot create cured.frob

An output, and a program without signatures:

  $ cat > light.frob <<'FROB'
  > import Robot
  > 
  > main :: SF RobotInput RobotOutput
  > main = proc _ -> roMake (setLight On)
  > FROB
  $ frobc check light.frob 2>&1 | grep '^error\|note\|hint'
  error[E0360]: a Pioneer does not have the capability `HasLight`, which `setLight` needs
      = note: `RobotOutput` is the output of a Pioneer
      = note: robots with `HasLight`: Create
      = hint: for such a robot, write `main :: (HasOdometry i, HasLight o) => SF i o`, and compile with `--robot create`
  $ sed 's/:: SF.*/:: (HasOdometry i, HasLight o) => SF i o/' light.frob > cured.frob
  $ frobc check --robot create cured.frob
  $ grep -v :: light.frob > unsigned.frob
  $ frobc check --robot pioneer unsigned.frob 2>&1 | grep '^error\|note\|hint'
  error[E0503]: `pioneer` has no `HasLight`
    = note: only `create` has this capability
    = note: `main` is compiled for `pioneer`, but there is no instance `HasLight PioneerOutput`
    = hint: compile it with `--robot create`

A robot that the program defines itself is not offered, because `--robot` does not know its name:

  $ cat > Android.frob <<'FROB'
  > module Android where
  > 
  > import Capability
  > 
  > data AndroidInput = AndroidInput { atEdge :: Bool }
  > 
  > instance HasCliffs AndroidInput where
  >     cliffLeft i = i.atEdge
  >     cliffRight i = i.atEdge
  >     wheelDropped _ = False
  > FROB
  $ sed 's/^import Robot/import Robot\nimport Android/' cliff.frob > own.frob
  $ frobc check own.frob 2>&1 | grep -o 'robots with.*\|compile with.*'
  robots with `HasCliffs`: Create
  compile with `--robot create`
