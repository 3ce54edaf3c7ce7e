  $ ../../explain/message.exe E0217
  main.frob:
  type Speeds = (Velocity, Speeds)
  
  error[E0217]: the type alias `Speeds` is defined in terms of itself
   --> main.frob:1:6
    |
  1 | type Speeds = (Velocity, Speeds)
    |      ^^^^^^
  
  1 error
