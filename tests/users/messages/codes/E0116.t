  $ ../../explain/message.exe E0116
  main.frob:
  slow :: SF (Bool, Float) Float
  slow = proc (careful, x) -> do
      if careful then returnA -< x / 2.0 else returnA -< x
  
  error[E0116]: `if` and `case` cannot choose between commands
   --> main.frob:3:29
    |
  3 |     if careful then returnA -< x / 2.0 else returnA -< x
    |     --                      ^^
    |     |
    |     this chooses between commands
    |
    = hint: choose the input, as in `returnA -< if c then a else b`, or run both commands and choose between their outputs
  
  1 error
