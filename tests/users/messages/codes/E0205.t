  $ ../../explain/message.exe E0205
  main.frob:
  halve :: Float -> Float
  halve speed = sped / 2
  
  error[E0205]: unknown name `sped`
   --> main.frob:2:15
    |
  2 | halve speed = sped / 2
    |               ^^^^
    |
    = hint: did you mean `speed`?
  
  1 error
