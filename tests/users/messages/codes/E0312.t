  $ ../../explain/message.exe E0312
  main.frob:
  mean :: Int -> Int -> Float
  mean a b = toFloat a / 2 + b / 2
  
  error[E0312]: expected `Float`, found `Int`
   --> main.frob:2:28
    |
  2 | mean a b = toFloat a / 2 + b / 2
    |                            ^ - argument 1 of `/` is `Float`
    |
    = hint: for a whole number, write `div b 2`, which rounds down; for a number with a fraction, write `toFloat b / 2`
  
  1 error
