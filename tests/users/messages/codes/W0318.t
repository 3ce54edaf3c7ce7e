  $ ../../explain/message.exe W0318
  main.frob:
  import Robot
  
  main :: Program RobotInput RobotOutput
  main = reactimateTask (do
      forever (turnBy 90[deg])
      forward 1[m])
  
  warning[W0318]: this statement is never reached
   --> main.frob:6:5
    |
  5 |     forever (turnBy 90[deg])
    |     ------- this task never ends
  6 |     forward 1[m])
    |     ^^^^^^^^^^^^
    |
    = hint: remove the statements after the task, or end the task with ``t `timeOut` 30[s]`` or with `abortWhen` and an event
  
  1 warning
