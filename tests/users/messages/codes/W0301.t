  $ ../../explain/message.exe W0301
  main.frob:
  orZero :: Maybe Float -> Float
  orZero m = case m of
      _ -> 0.0
      Just x -> x
  
  warning[W0301]: this branch is never taken
   --> main.frob:4:5
    |
  4 |     Just x -> x
    |     ^^^^^^ the branches before it cover all its values
  
  1 warning
