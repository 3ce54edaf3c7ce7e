  $ ../../explain/message.exe E0361
  main.frob:
  class Shape a where
      area :: a -> Float
  
  data Square = Square { side :: Float }
  
  instance Shape Square where
      area s = s.side * s.side
  
  instance Shape Square where
      area s = s.side ^ 2
  
  error[E0361]: there are two `Shape Square` instances
   --> main.frob:9:10
    |
  6 | instance Shape Square where
    |          ------------ the first one is here
  ...
  9 | instance Shape Square where
    |          ^^^^^^^^^^^^
    |
    = note: a class can have only one instance for each type constructor
  
  1 error
