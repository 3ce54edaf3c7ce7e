  $ ../../explain/message.exe E0362
  main.frob:
  class Shape a where
      area :: a -> Float[m^2]
  
  data Square[u] = Square { side :: Float[u] }
  
  instance Shape Square[m] where
      area s = s.side * s.side
  
  error[E0362]: the head of an instance must be a type constructor applied to distinct variables, not `Square[m]`
   --> main.frob:6:16
    |
  6 | instance Shape Square[m] where
    |                ^^^^^^^^^
    |
    = note: a unit cannot select an instance
    = hint: write a unit variable, as in `Float[u]`
  
  1 error
