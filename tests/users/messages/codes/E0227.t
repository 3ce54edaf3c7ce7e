  $ ../../explain/message.exe E0227
  main.frob:
  (***) :: Float -> Float -> Float
  (***) a b = a * b * b
  
  error[E0227]: a program cannot define operators
   --> main.frob:2:2
    |
  2 | (***) a b = a * b * b
    |  ^^^
    |
    = hint: give the function a name; with backticks you can write it between its arguments: a `f` b
  
  1 error
