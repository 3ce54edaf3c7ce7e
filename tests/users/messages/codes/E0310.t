  $ ../../explain/message.exe E0310
  main.frob:
  data Side = Side { range :: Distance, angle :: Angle }
  
  ahead :: Side -> Distance
  ahead side = side.rang
  
  error[E0310]: `Side` has no field `rang`
   --> main.frob:4:19
    |
  4 | ahead side = side.rang
    |              ---- ^^^^
    |              |
    |              this is `Side`
    |
    = hint: did you mean `range`?
  
  1 error
