  $ ../../explain/message.exe E0211
  main.frob:
  gain :: Float
  gain = 2.0
  gain = 3.0
  
  error[E0211]: the name `gain` is defined twice
   --> main.frob:3:1
    |
  2 | gain = 2.0
    | ---- first defined here
  3 | gain = 3.0
    | ^^^^
    |
    = hint: remove one of them, or rename it
  
  1 error
