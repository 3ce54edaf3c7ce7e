  $ ../../explain/message.exe E0230
  main.frob:
  class Shape a where
      area :: a -> Float
  
  data Square = Square { side :: Float }
  
  instance Shape Square where
      area s = s.side * s.side
      border s = 4 * s.side
  
  error[E0230]: `border` is not a method of the class `Shape`
   --> main.frob:8:5
    |
  1 | class Shape a where
    |       ----- the methods are declared here
  ...
  8 |     border s = 4 * s.side
    |     ^^^^^^
    |
    = hint: if it is a separate function, move it to the left margin; if every `Shape` must have it, add its signature to the class
  
  1 error
