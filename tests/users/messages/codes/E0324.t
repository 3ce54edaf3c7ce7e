  $ ../../explain/message.exe E0324
  main.frob:
  unit nothing = 0 m
  
  error[E0324]: the scale of the unit `nothing` is out of range
   --> main.frob:1:6
    |
  1 | unit nothing = 0 m
    |      ^^^^^^^
    |
    = note: a scale must be a positive number between 1e-150 and 1e150
  
  1 error
