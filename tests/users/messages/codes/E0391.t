  $ ../../explain/message.exe E0391
  main.frob:
  param reach :: Distance = 2[m]
  param near :: Distance = reach / 4
  
  main :: SF Distance Bool
  main = proc d -> d < near
  
  error[E0391]: the value of the parameter `near` must be known before the run
   --> main.frob:2:26
    |
  2 | param near :: Distance = reach / 4
    |                          ^^^^^^^^^
    |
    = note: it depends on the parameter `reach`, which can be set for each run
    = hint: define it without `param`: `near = …`
  
  1 error
