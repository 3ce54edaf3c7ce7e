  $ ../../explain/message.exe E0114
  main.frob:
  next :: Int -> Int
  next n = case n of
    k + 1 -> k
    0 -> 0
  
  error[E0114]: the operator `+` cannot be part of a pattern
   --> main.frob:3:5
    |
  3 |   k + 1 -> k
    |     ^
  
  1 error
