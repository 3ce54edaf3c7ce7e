  $ ../../explain/message.exe E0344
  main.frob:
  scale :: SF (Float, Float) Float
  scale = proc (k, x) -> s x where
      s = proc y -> k * y
  
  error[E0344]: `s` is a signal function and must be static, but `k` is a signal
   --> main.frob:3:19
    |
  2 | scale = proc (k, x) -> s x where
    |               - `k` is a signal: it comes from the `proc`'s input here
  3 |     s = proc y -> k * y
    |                   ^
    |
    = hint: pass signals in its input: `s` can take a pair, as in `proc (x, y) -> …`; to pass a value from one mode to the next, use the event of the switch
  
  1 error
