  $ ../../explain/message.exe E0363
  main.frob:
  class Shape a where
      area :: a -> Float
      weight :: a -> Float
      weight s = 2 * area s
  
  data Square = Square { side :: Float }
  
  instance Shape Square where
  
  error[E0363]: the instance `Shape Square` does not define `area`
   --> main.frob:8:10
    |
  2 |     area :: a -> Float
    |             ---------- `area` has no default
  ...
  8 | instance Shape Square where
    |          ^^^^^^^^^^^^
    |
    = hint: below the `where` of the instance, define `area = …`
  
  1 error
