  $ ../../explain/message.exe E0364
  main.frob:
  class Shape a where
      corners :: Int
  
  error[E0364]: the type of the method `corners` does not contain `a`
   --> main.frob:2:5
    |
  2 |     corners :: Int
    |     ^^^^^^^    --- nothing here determines the instance
  
  1 error
