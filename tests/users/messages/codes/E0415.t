  $ ../../explain/message.exe E0415
  main.frob:
  go :: SF Float Float
  go = switch (proc x -> (x, edge (x > 1))) (\_ -> go >>> constant 2)
  
  main :: SF Float Float
  main = go
  
  error[E0415]: `go` restarts itself inside itself
   --> main.frob:2:50
    |
  2 | go = switch (proc x -> (x, edge (x > 1))) (\_ -> go >>> constant 2)
    |                                                  ^^^^^^^^^^^^^^^^^ here, inside `>>>`
    |
    = note: a signal function may only restart itself as the whole result of a continuation; otherwise each restart would need more memory
    = hint: apply `>>>` once, where the first mode starts, not in each mode
  
  1 error
