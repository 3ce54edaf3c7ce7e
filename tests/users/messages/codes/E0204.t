  $ ../../explain/message.exe E0204
  main.frob:
  primitive sinh :: Float -> Float
  
  error[E0204]: only the standard library can declare primitives
   --> main.frob:1:11
    |
  1 | primitive sinh :: Float -> Float
    |           ^^^^
  
  1 error
