  $ ../../explain/message.exe E0112
  main.frob:
  data Side = LeftSide | RightSide deriving Eq
  
  error[E0112]: Frob has no `deriving`
   --> main.frob:1:34
    |
  1 | data Side = LeftSide | RightSide deriving Eq
    |                                  ^^^^^^^^
    |
    = hint: remove it: `==` and `<` work on all data that contains no functions
  
  1 error
