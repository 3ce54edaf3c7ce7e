  $ ../../explain/message.exe E0331
  main.frob:
  total :: Float
  total = foldl (+) 0 (generate toFloat)
  
  error[E0331]: nothing determines the size of an array where `generate` is used
   --> main.frob:2:22
    |
  2 | total = foldl (+) 0 (generate toFloat)
    |                      ^^^^^^^^
    |
    = hint: add a type annotation, as in `(e :: Array 4 Float)`, or give the definition a signature
  
  1 error
