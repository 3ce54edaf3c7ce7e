  $ ../../explain/message.exe E0209
  main.frob:
  data Range = Range { low :: Float, high :: Float }
  
  unitRange :: Range
  unitRange = Range { low = 0, hihg = 1, high = 1 }
  
  error[E0209]: constructor `Range` has no field `hihg`
   --> main.frob:4:30
    |
  1 | data Range = Range { low :: Float, high :: Float }
    |              ----- declared here
  ...
  4 | unitRange = Range { low = 0, hihg = 1, high = 1 }
    |                              ^^^^
    |
    = hint: did you mean `high`?
  
  1 error
