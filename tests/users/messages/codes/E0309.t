  $ ../../explain/message.exe E0309
  main.frob:
  isEither :: a -> a -> a -> Bool
  isEither x y z = z == x || z == y
  
  error[E0309]: `==` needs `Eq a`, which the signature of `isEither` does not declare
   --> main.frob:2:20
    |
  1 | isEither :: a -> a -> a -> Bool
    |             ------------------- the signature of `isEither`
  2 | isEither x y z = z == x || z == y
    |                    ^^
    |
    = hint: write `Eq a => a -> a -> a -> Bool`
  
  1 error
