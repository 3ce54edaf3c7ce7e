  $ ../../explain/message.exe E0323
  main.frob:
  odd :: Float
  odd = 1[mm^12] / 1[m^12]
  
  error[E0323]: the exponent of a unit is too large
   --> main.frob:2:9
    |
  2 | odd = 1[mm^12] / 1[m^12]
    |         ^^^^^
  
  1 error
