  $ ../../explain/message.exe E0229
  main.frob:
  class Round a => Shape a where
      area :: a -> Float
  
  class Shape a => Round a where
      radius :: a -> Float
  
  error[E0229]: the class `Shape` is its own superclass
   --> main.frob:1:18
    |
  1 | class Round a => Shape a where
    |                  ^^^^^
  ...
  4 | class Shape a => Round a where
    |                  ----- through `Round`
  
  1 error
