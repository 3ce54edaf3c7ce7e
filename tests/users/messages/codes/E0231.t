  $ ../../explain/message.exe E0231
  main.frob:
  class Shape a where
      area :: a -> Float
  
  data Square = Square { side :: Float }
  
  instance Shape Square where
      area :: Square -> Float
      area s = s.side * s.side
  
  error[E0231]: an instance cannot contain a signature
   --> main.frob:7:5
    |
  1 | class Shape a where
    |       ----- the class declares the type of `area`
  ...
  7 |     area :: Square -> Float
    |     ^^^^
    |
    = hint: remove the signature
  
  1 error
