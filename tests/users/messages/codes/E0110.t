  $ ../../explain/message.exe E0110
  main.frob:
  limit :: Float -> Float
  limit x = if x > 1.0 then 1.0
  
  error[E0110]: expected `else` after the first branch, found the end of the file
   --> main.frob:2:30
    |
  2 | limit x = if x > 1.0 then 1.0
    |                              ^
    |
    = hint: add an `else`: every `if` has a value
  
  1 error
