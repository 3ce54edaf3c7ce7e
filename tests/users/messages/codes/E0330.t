  $ ../../explain/message.exe E0330
  main.frob:
  data Scan n = Scan { ranges :: Array n Float }
  
  first :: Scan Float -> Float
  first scan = scan.ranges ! 0
  
  error[E0330]: expected the size of an array, found the type `Float`
   --> main.frob:3:15
    |
  3 | first :: Scan Float -> Float
    |               ^^^^^
    |
    = hint: write the size first, as in `Array 4 Float`
  
  1 error
