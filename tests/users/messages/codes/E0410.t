  $ ../../explain/message.exe E0410
  main.frob:
  halvings :: Float -> Float
  halvings x = if x < 1 then 0 else 1 + halvings (x / 2)
  
  main :: SF Float Float
  main = arr halvings
  
  error[E0410]: `halvings` calls itself
   --> main.frob:2:1
    |
  2 | halvings x = if x < 1 then 0 else 1 + halvings (x / 2)
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |                                       |
    |                                       `halvings` uses `halvings` here
    |
    = note: functions cannot be recursive: use `foldl` or `scanl` to process an array; a signal function may only restart itself in the continuation of a switch
    = hint: for a value that depends on its own past, write an equation with `delay` in a `proc`, as in `n = delay 0 n + 1`
  
  1 error
