  $ ../../explain/message.exe E0216
  main.frob:
  import Geometry
  
  goal :: Vec2
  goal = Vec2 { x = 1[m], y = 2[m] }
  
  error[E0216]: type `Vec2` takes 1 unit argument, not 0
   --> main.frob:3:9
    |
  3 | goal :: Vec2
    |         ^^^^
    |
   ::: stdlib/Geometry.frob:7:6
    |
  7 | data Vec2[u] = Vec2 { x :: Float[u], y :: Float[u] }
    |      ---- declared here
    |
    = hint: write `Vec2[1]` for plain numbers, or add the unit of the numbers, as in `Vec2[m]`
  
  1 error
