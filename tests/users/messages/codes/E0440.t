  $ ../../explain/message.exe E0440
  main.frob:
  import Robot
  
  main = reactimateRobot (proc i -> roMake (setVelTR (if lit i then 0.2[m/s] else 0) 0))
  
  lit i = buttonHeld (if bumped i then "back" else "ahead") i
  
  error[E0440]: this label is not known at compile time
   --> main.frob:5:9
    |
  5 | lit i = buttonHeld (if bumped i then "back" else "ahead") i
    |         ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: give each button and knob a fixed label, and choose between their values
  
  1 error
