  $ ../../explain/message.exe E0365
  main.frob:
  class Shape a where
      area :: a -> Float
  
  data Square = Square { side :: Float }
  
  instance Shape Square where
      area s = s.side * s.side
  
  double :: Shape Square => Square -> Float
  double s = 2 * area s
  
  error[E0365]: a context can only constrain a variable, not `Square`
   --> main.frob:9:11
    |
  9 | double :: Shape Square => Square -> Float
    |           ^^^^^^^^^^^^
  
  1 error
