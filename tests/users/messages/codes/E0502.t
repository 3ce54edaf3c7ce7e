  $ ../../explain/message.exe E0502
  main.frob:
  import Robot
  
  main :: (HasSonar i, DiffDrive o) => Program i o
  main = reactimateRobot (proc i -> roMake (setVelTR (0.5[1/s] * frontSonar i) 0))
  
  error[E0502]: the type of `main` does not say which robot it runs on
   --> main.frob:4:1
    |
  4 | main = reactimateRobot (proc i -> roMake (setVelTR (0.5[1/s] * frontSonar i) 0))
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: `pioneer`, `scout`, `create` and `ros` have everything that the program needs: compile it with `--robot pioneer`, `--robot scout`, `--robot create` or `--robot ros`
  
  1 error
