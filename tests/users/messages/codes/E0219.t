  $ ../../explain/message.exe E0219
  main.frob:
  unit foot = 12 inch
  unit inch = 0.083333 foot
  
  error[E0219]: the unit `foot` is defined in terms of itself
   --> main.frob:1:6
    |
  1 | unit foot = 12 inch
    |      ^^^^
  2 | unit inch = 0.083333 foot
    |      ---- through `inch`
  
  1 error
