  $ ../../explain/message.exe E0214
  main.frob:
  maxSpeed :: Velocity
  maxSped = 0.4[m/s]
  
  error[E0214]: `maxSpeed` has a signature but no definition
   --> main.frob:1:1
    |
  1 | maxSpeed :: Velocity
    | ^^^^^^^^
    |
    = hint: did you mean `maxSped`?
  
  1 error
