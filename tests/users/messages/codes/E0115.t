  $ ../../explain/message.exe E0115
  main.frob:
  sign :: Int -> Int
  sign 0 = 0
  sign n = 1
  
  error[E0115]: `sign` is defined by several clauses
   --> main.frob:3:1
    |
  2 | sign 0 = 0
    | ---- the first
  3 | sign n = 1
    | ^^^^
    |
    = hint: write one clause, `sign x = case x of`; on the lines below it, write a branch `pattern -> value` for each clause
  
  1 error
