  $ ../../explain/message.exe W0310
  main.frob:
  import Create
  import Robot
  
  main :: Program CreateInput CreateOutput
  main = reactimateRobot (proc i -> roMake (setVelTR (if frontSonar i < 0.6[m] then 0[m/s] else 0.2[m/s]) 0[rad/s]))
  
  warning[W0310]: this is always True: on a Create, `frontSonar` is at most 0.5 m
   --> main.frob:5:56
    |
  5 | main = reactimateRobot (proc i -> roMake (setVelTR (if frontSonar i < 0.6[m] then 0[m/s] else 0.2[m/s]) 0[rad/s]))
    |                                                        ^^^^^^^^^^^^^^^^^^^^^
    |
    = note: when nothing is in range, the reading is `sonarReach i`
    = hint: compare the reading with a smaller distance
  
  1 warning
