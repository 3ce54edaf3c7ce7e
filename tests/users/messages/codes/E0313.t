  $ ../../explain/message.exe E0313
  main.frob:
  population :: Int
  population = 8000000000
  
  error[E0313]: `8000000000` is out of range for an `Int`
   --> main.frob:2:14
    |
  2 | population = 8000000000
    |              ^^^^^^^^^^
    |
    = note: an `Int` must be between -2147483648 and 2147483647
  
  1 error
