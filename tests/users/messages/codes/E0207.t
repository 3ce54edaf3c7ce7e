  $ ../../explain/message.exe E0207
  main.frob:
  speed :: Velocty
  speed = 0.4[m/s]
  
  error[E0207]: unknown type `Velocty`
   --> main.frob:1:10
    |
  1 | speed :: Velocty
    |          ^^^^^^^
    |
    = hint: did you mean `Velocity`?
  
  1 error
