  $ ../../explain/message.exe E0332
  main.frob:
  last :: Array 3 Float -> Float
  last xs = xs ! 3
  
  error[E0332]: index 3 is out of range for an array of 3 elements
   --> main.frob:2:16
    |
  2 | last xs = xs ! 3
    |           --   ^
    |           |
    |           this is `Array 3 Float`
    |
    = hint: the first element is `xs ! 0`, the last `xs ! 2`; check the other indices too
  
  1 error
