A task that is applied to the input of a `proc`, like a signal function.

  $ cat > equation.frob <<'FROB'
  > import Geometry
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot go
  > go :: SF RobotInput RobotOutput
  > go = proc i -> out where
  >     goal = Vec2 { x = 2[m], y = 0 }
  >     out  = driveTo goal i
  > FROB
  $ frobc check equation.frob
  error[E0302]: `driveTo` takes 1 argument, but is given 2
   --> equation.frob:8:25
    |
  8 |     out  = driveTo goal i
    |            -------      ^ one too many
    |            |
    |            with one argument, its result is `Task a b Bool`
    |
    = hint: a `proc` cannot run a task, because a task takes time: compute a value here, or run `driveTo goal` in a `do`, as in `main = reactimateTask (do …)`
  
  1 error
  [1]
  $ cat > pasted.frob <<'FROB'
  > import Geometry
  > import Robot
  > main = reactimateTask $ do
  >     driveTo goal
  >     standStill
  > goal = Vec2 { x = 2[m], y = 0 }
  > standStill :: Task RobotInput RobotOutput ()
  > standStill = sleepT 1[s] (roMake (setVelTR 0 0))
  > FROB
  $ frobc check pasted.frob
