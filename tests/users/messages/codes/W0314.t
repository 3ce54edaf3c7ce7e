  $ ../../explain/message.exe W0314
  main.frob:
  import Control
  
  main :: SF Distance Velocity
  main = proc x -> (x - previous x) / stepTime ()
  
  warning[W0314]: this divides by the length of the step, which is 0 at the first instant
   --> main.frob:4:18
    |
  4 | main = proc x -> (x - previous x) / stepTime ()
    |                  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: at that instant the quotient is infinite, or NaN if the dividend is also 0
    = hint: for the slope of a signal, use `derivative`; otherwise divide only in a branch where the step is longer than 0
  
  1 warning
