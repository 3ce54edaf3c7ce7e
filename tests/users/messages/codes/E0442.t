  $ ../../explain/message.exe E0442
  main.frob:
  import Robot
  
  main = reactimateRobot (proc i -> roMake (setVelTR (speed i) (turn i)))
  
  speed i = knob "gain" 0 0.4[m/s] 0.2[m/s] i
  turn i = knob "gain" 0 1[rad/s] 0 i
  
  error[E0442]: the console already has another control with the label `gain`
   --> main.frob:6:10
    |
  5 | speed i = knob "gain" 0 0.4[m/s] 0.2[m/s] i
    |           --------------------------------- a knob from 0 to 0.4, initially 0.2
  6 | turn i = knob "gain" 0 1[rad/s] 0 i
    |          ^^^^^^^^^^^^^^^^^^^^^^^^^^ a knob from 0 to 1, initially 0
    |
    = hint: rename one of them
  
  1 error
