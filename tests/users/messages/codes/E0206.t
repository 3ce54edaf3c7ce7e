  $ ../../explain/message.exe E0206
  main.frob:
  isLeft :: Either a b -> Bool
  isLeft e = case e of
      Lefft _ -> True
      Right _ -> False
  
  error[E0206]: unknown constructor `Lefft`
   --> main.frob:3:5
    |
  3 |     Lefft _ -> True
    |     ^^^^^
    |
    = hint: did you mean `Left`?
  
  1 error
