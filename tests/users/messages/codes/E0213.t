  $ ../../explain/message.exe E0213
  main.frob:
  data Range = Range { low :: Float, high :: Float }
  
  widen :: Range -> Range
  widen r = r { low = 0, low = 1 }
  
  error[E0213]: field `low` is set twice
   --> main.frob:4:24
    |
  4 | widen r = r { low = 0, low = 1 }
    |               ---      ^^^
    |               |
    |               first set here
  
  1 error
