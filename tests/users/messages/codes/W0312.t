  $ ../../explain/message.exe W0312
  main.frob:
  import Driving
  import Robot
  
  main :: Program RobotInput RobotOutput
  main = reactimateTask (do
      forward 1[m]
      return ()
      forward 1[m])
  
  warning[W0312]: this `return` has no effect: the statements after it still run
   --> main.frob:7:5
    |
  7 |     return ()
    |     ^^^^^^^^^
    |
    = hint: remove it: a task ends after its last statement
  
  1 warning
