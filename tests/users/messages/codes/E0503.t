  $ ../../explain/message.exe E0503
  main.frob:
  import Robot
  
  main :: (HasSonarRing i, HasCliffs i, DiffDrive o) => Program i o
  main = reactimateRobot (proc i -> roMake (setVelTR (speed i) 0)) where
      speed i = if cliffAhead i || isEvent ((sonars i ! 0).echo) then 0 else 0.2[m/s]
  
  error[E0503]: no robot has everything that `main` needs
   --> main.frob:4:1
    |
  4 | main = reactimateRobot (proc i -> roMake (setVelTR (speed i) 0)) where
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  5 |     speed i = if cliffAhead i || isEvent ((sonars i ! 0).echo) then 0 else 0.2[m/s]
    |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |                  |                         |
    |                  |                         `create` has no `HasSonarRing`, which `sonars` needs
    |                  `pioneer` has no `HasCliffs`, which `cliffAhead` needs
    |                  `scout` has no `HasCliffs`, which `cliffAhead` needs
    |                  `ros` has no `HasCliffs`, which `cliffAhead` needs
    |
    = note: for your own robot, give the file of its module: `--robot FILE.frob`
  
  1 error
