  $ ../../explain/message.exe E0333
  main.frob:
  none :: Array 0 Float -> Float
  none xs = 0
  
  error[E0333]: the size of an array must be from 1 to 1048576, not 0
   --> main.frob:1:15
    |
  1 | none :: Array 0 Float -> Float
    |               ^
  
  1 error
