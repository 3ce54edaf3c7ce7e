  $ ../../explain/message.exe E0416
  main.frob:
  go :: SF Float Float -> SF Float Float
  go sf = switch (proc x -> (sf x, edge (x > 1))) (\_ -> go (sf >>> delay 0))
  
  main :: SF Float Float
  main = go identity
  
  error[E0416]: `go` grows each time it restarts itself
   --> main.frob:2:56
    |
  2 | go sf = switch (proc x -> (sf x, edge (x > 1))) (\_ -> go (sf >>> delay 0))
    |                                                        ^^^^^^^^^^^^^^^^^^^ it restarts here, with one more `>>>`
    |
    = note: frobc must know all signal functions that can run, so their number must be finite
    = hint: restart it with the same signal functions each time; only numbers may change
  
  1 error
