  $ ../../explain/message.exe E0340
  main.frob:
  import Control
  
  smooth :: SF (Float, Bool) Float
  smooth = proc (x, noisy) -> lowPass tau x where
      tau = if noisy then 1[s] else 0.1[s]
  
  error[E0340]: the arguments of `lowPass` before its signal must be static, but `tau` is a signal
   --> main.frob:4:37
    |
  4 | smooth = proc (x, noisy) -> lowPass tau x where
    |                   -----             ^^^
    |                   |
    |                   `noisy` is a signal: it comes from the `proc`'s input here
  5 |     tau = if noisy then 1[s] else 0.1[s]
    |              ----- `tau` is a signal: it depends on `noisy` here
    |
    = hint: run one instance for each setting, and choose between their outputs: add the equations `one = lowPass 1[s] x` and `two = lowPass 0.1[s] x`, and write `if noisy then one else two` here
  
  1 error
