`frobc explain` tells what a diagnostic means, in any case of letters.

  $ frobc explain e0401
  # A signal needs its own value in the same instant
  
  The equations of a `proc` all hold at every instant, and may refer to each
  other in any order. But each value must be computable from others: if, within
  one instant, a signal is needed to compute itself, there is no order in which
  to evaluate the equations, and usually no single solution either. The message
  shows the loop, one signal after the other; the loop may lead through signal
  functions that pass an input on to an output in the same instant. Tuples and
  records are judged component by component.
  
  ```frob-error
  main :: SF Float Float
  main = proc target -> speed where
      err   = target - speed
      speed = 0.5 * err
  ```
  
  Somewhere in the loop the value of the instant before is meant: read it with
  `delay`, and say what it is at the first instant. `integral` breaks a loop too,
  as it adds up what its input was until now; `derivative` does not.
  
  ```frob
  main :: SF Float Float
  main = proc target -> speed where
      err   = target - delay 0 speed
      speed = 0.5 * err
  ```

  $ frobc explain E9401
  error: there is no diagnostic `E9401`; did you mean `E0401`?
  [2]
