  $ ../../explain/message.exe E0350
  main.frob:
  data Side = LeftSide | RightSide
  
  sign :: Side -> Float
  sign s = case s of
      LeftSide -> 1.0
  
  error[E0350]: this `case` does not cover every value
   --> main.frob:4:15
    |
  4 | sign s = case s of
    |               ^ there is no branch for `RightSide`
    |
    = hint: add a branch `RightSide -> …`
  
  1 error
