  $ ../../explain/message.exe E0113
  main.frob:
  inside :: Float -> Bool
  inside x = 0.0 < x < 1.0
  
  error[E0113]: `<` and `<` cannot be combined without parentheses
   --> main.frob:2:20
    |
  2 | inside x = 0.0 < x < 1.0
    |                -   ^
    |                |
    |                after this one
    |
    = hint: compare two values at a time: `0.0 < x && x < 1.0`
  
  1 error
