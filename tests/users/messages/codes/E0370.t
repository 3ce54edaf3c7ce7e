  $ ../../explain/message.exe E0370
  main.frob:
  wait :: Task Float Float Float
  wait = do
      x <- snapT
      sleepT 1[s] 0
      2 * x
  
  error[E0370]: each statement in a `do` must be a task, but this is `Float`
   --> main.frob:5:5
    |
  1 | wait :: Task Float Float Float
    |         ---------------------- the signature of `wait` requires `Task Float Float Float`
  ...
  5 |     2 * x
    |     ^^^^^
    |
    = hint: use `let x = …` to name a value, or `return x` for a task that returns it immediately
  
  1 error
