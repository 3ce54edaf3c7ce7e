`frobc explain` explains a diagnostic; the code may be in upper or lower case.

  $ frobc explain e0401
  # a signal needs its own value in the same instant
  
  The equations of a `proc` hold at every instant and can refer to each other in any order. But if a
  signal depends on its own value in the same instant, no order of evaluation exists. The message
  shows the loop, one signal after the other. The loop can pass through signal functions whose output
  depends on their input in the same instant. The components of tuples and records are separate
  signals.
  
  ```frob-error
  main :: SF Float Float
  main = proc target -> speed where
      err   = target - speed
      speed = 0.5 * err
  ```
  
  Choose a signal in the loop for which the value from the previous instant is good enough, and read
  that value with `delay`, which also needs a value for the first instant. `integral` breaks a loop
  too, because it only adds up past inputs. `derivative` does not.
  
  ```frob
  main :: SF Float Float
  main = proc target -> speed where
      err   = target - delay 0 speed
      speed = 0.5 * err
  ```

  $ frobc explain E9401
  error: there is no diagnostic `E9401`; did you mean `E0401`?
  [2]
