  $ ../../explain/message.exe E0302
  main.frob:
  largest :: Float
  largest = abs 1.0 2.0
  
  error[E0302]: `abs` takes 1 argument, but is given 2
   --> main.frob:2:19
    |
  2 | largest = abs 1.0 2.0
    |           ---     ^^^ one too many
    |           |
    |           with one argument, its result is `Float`
    |
    = hint: `abs :: n[u] -> n[u]`
  
  1 error
