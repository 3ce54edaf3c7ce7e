  $ ../../explain/message.exe E0417
  main.frob:
  go :: Eq a => a -> SF Float Float
  go v = switch (proc x -> (x, edge (x > 1 && v == v))) (\_ -> go (v, v))
  
  main :: SF Float Float
  main = go 1
  
  error[E0417]: `go` restarts itself at a larger type
   --> main.frob:2:62
    |
  2 | go v = switch (proc x -> (x, edge (x > 1 && v == v))) (\_ -> go (v, v))
    | -------------------------------------------------------------^^--------
    | |                                                            |
    | |                                                            here its type variable becomes `(a, a)`
    | `go` is defined here
    |
    = hint: restart it with the same types
  
  1 error
