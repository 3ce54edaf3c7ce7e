  $ ../../explain/message.exe E0441
  main.frob:
  import Robot
  
  main = reactimateRobot (proc i -> roMake (setVelTR (top i) 0))
  
  -- minimum, maximum, initial value
  top i = knob "speed" 0 0.4[m/s] 0.5[m/s] i
  
  error[E0441]: the initial value of this knob, 0.5, is outside its limits, 0 and 0.4
   --> main.frob:6:9
    |
  6 | top i = knob "speed" 0 0.4[m/s] 0.5[m/s] i
    |         ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  
  1 error
