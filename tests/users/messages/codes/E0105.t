  $ ../../explain/message.exe E0105
  main.frob:
  distance :: Float[m]
  distance = 0.2m
  
  error[E0105]: the number `0.2` is directly followed by `m`
   --> main.frob:2:12
    |
  2 | distance = 0.2m
    |            ^^^^
    |
    = hint: put the unit in brackets: `0.2[m]`
  
  1 error
