  $ ../../explain/message.exe E0210
  main.frob:
  import Geometry
  import Walls
  
  setpoint :: Distance
  setpoint = distance
  
  Walls.frob:
  distance :: Distance
  distance = 0.2[m]
  
  error[E0210]: the name `distance` is ambiguous
    --> main.frob:5:12
     |
   5 | setpoint = distance
     |            ^^^^^^^^
     |
    ::: stdlib/Geometry.frob:56:1
     |
  56 | distance a b = norm (a ^-^ b)
     | -------- defined in `Geometry`
     |
    ::: Walls.frob:2:1
     |
   2 | distance = 0.2[m]
     | -------- defined in `Walls`
     |
     = hint: write `Geometry.distance` or `Walls.distance`
  
  1 error
