  $ ../../explain/message.exe E0102
  main.frob:
  limit :: Float -> Float
  limit x = min x top
    where
  	top = 1.0
  
  error[E0102]: tabs are not allowed, because indentation is significant
   --> main.frob:4:1
    |
  4 |     top = 1.0
    | ^^^^
    |
    = hint: set up your editor to insert spaces instead of tabs
  
  1 error
