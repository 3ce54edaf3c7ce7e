  $ ../../explain/message.exe E0507
  main.frob:
  vMax :: Velocity
  vMax = 0.4[m/s]
  
  main :: SF Velocity Velocity
  main = proc v -> min v vMax
  
  error[E0507]: the program has no parameter `speed`
   --> --param speed:1:1
    |
  1 | speed= 0.3[m/s]
    | ^
    |
    = note: the program has no parameters; declare one with `param NAME :: TYPE = VALUE`
  
  1 error
