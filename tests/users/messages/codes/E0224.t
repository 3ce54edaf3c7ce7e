  $ ../../explain/message.exe E0224
  main.frob:
  data Interval[m] = Interval Float[m] Float[m]
  
  error[E0224]: the unit parameter `m` has the same name as a unit
   --> main.frob:1:15
    |
  1 | data Interval[m] = Interval Float[m] Float[m]
    |               ^
    |
    = hint: use a letter that is not a unit, such as `u`
  
  1 error
