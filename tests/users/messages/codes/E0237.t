  $ ../../explain/message.exe E0237
  main.test.frob:
  main = reactimateRobot (constant (setVelTR 0[m/s] 0[rad/s]))
  
  main.frob:
  import Robot
  
  gentle :: Velocity -> Velocity
  gentle v = v / 2
  
  main = reactimateRobot (constant (setVelTR (gentle 0.4[m/s]) 0[rad/s]))
  
  error[E0237]: a test file cannot define `main`
   --> main.test.frob:1:1
    |
  1 | main = reactimateRobot (constant (setVelTR 0[m/s] 0[rad/s]))
    | ^^^^
    |
    = hint: a program is compiled without its test file: define `main` in the program, or give this definition another name
  
  1 error
