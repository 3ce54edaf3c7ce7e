  $ ../../explain/message.exe E0351
  main.frob:
  value :: Maybe Float -> Float
  value = \(Just x) -> x
  
  error[E0351]: the pattern of a function must match every value
   --> main.frob:2:11
    |
  2 | value = \(Just x) -> x
    |           ^^^^^^ does not match `Nothing`
    |
    = hint: use a `case`, with a branch for `Nothing` too
  
  1 error
