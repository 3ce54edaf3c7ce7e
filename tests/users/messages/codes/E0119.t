  $ ../../explain/message.exe E0119
  main.frob:
  speed :: Float[m/s]
  speed = 3.0[10 m/s]
  
  error[E0119]: the number `10` cannot be part of a unit: the only number allowed there is `1`
   --> main.frob:2:13
    |
  2 | speed = 3.0[10 m/s]
    |             ^^
    |
    = hint: write a power as `m^2`; an array of 10 elements has the type `Array 10 Float`
  
  1 error
