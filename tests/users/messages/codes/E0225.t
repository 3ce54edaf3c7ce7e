  $ ../../explain/message.exe E0225
  main.frob:
  data Obstacle = Clear | Obstacle Distance Angle
  
  range :: Obstacle -> Distance
  range o = case o of
      Clear -> 5[m]
      Obstacle d -> d
  
  error[E0225]: constructor `Obstacle` has 2 arguments, not 1
   --> main.frob:6:5
    |
  1 | data Obstacle = Clear | Obstacle Distance Angle
    |                         -------- declared here
  ...
  6 |     Obstacle d -> d
    |     ^^^^^^^^^^
    |
    = hint: its pattern is `Obstacle a b`: write `_` for an argument that you do not use
  
  1 error
