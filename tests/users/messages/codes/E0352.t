  $ ../../explain/message.exe E0352
  main.frob:
  sign :: Float -> Float
  sign x
      | x < 0.0 = -1.0
      | x > 0.0 = 1.0
  
  error[E0352]: all these guards may fail
   --> main.frob:3:7
    |
  3 |     | x < 0.0 = -1.0
    |       ^^^^^^^^^^^^^^
  4 |     | x > 0.0 = 1.0
    |     ^^^^^^^^^^^^^^^ there is no value if they do
    |
    = hint: add a final guard, `| otherwise`
  
  1 error
