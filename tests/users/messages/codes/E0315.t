  $ ../../explain/message.exe E0315
  main.frob:
  huge :: Float
  huge = 1e999
  
  error[E0315]: the number `1e999` is out of range
   --> main.frob:2:8
    |
  2 | huge = 1e999
    |        ^^^^^
  
  1 error
