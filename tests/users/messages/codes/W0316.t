  $ ../../explain/message.exe W0316
  main.frob:
  import Control
  
  main :: SF Float (Float, Float)
  main = proc x -> (clamp 1 (-1) x, limit (-2) x)
  
  warning[W0316]: the lower limit of `clamp` is above the upper one
   --> main.frob:4:25
    |
  4 | main = proc x -> (clamp 1 (-1) x, limit (-2) x)
    |                         ^  -- the upper limit
    |
    = hint: swap them
  
  warning[W0316]: this is below zero: `limit` needs a number of at least 0
   --> main.frob:4:42
    |
  4 | main = proc x -> (clamp 1 (-1) x, limit (-2) x)
    |                                          ^^
    |
    = hint: remove the sign
  
  2 warnings
