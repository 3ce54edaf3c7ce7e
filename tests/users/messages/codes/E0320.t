  $ ../../explain/message.exe E0320
  main.frob:
  ahead :: Distance -> Velocity -> Distance
  ahead d v = d + v
  
  error[E0320]: the operands of `+` have different units: `m` and `m/s`
   --> main.frob:2:17
    |
  2 | ahead d v = d + v
    |             -   ^ this is `Velocity` (m/s)
    |             |
    |             this is `Distance` (m)
    |
    = hint: `v` is a rate of change: multiply it by a time, as in `d + v * 0.5[s]`
  
  1 error
