  $ ../../explain/message.exe E0307
  main.frob:
  same :: Bool
  same = sin == cos
  
  error[E0307]: `Angle -> Float` has no equality
   --> main.frob:2:12
    |
  2 | same = sin == cos
    |            ^^ `==` needs it
  
  1 error
