  $ ../../explain/message.exe E0311
  main.frob:
  data Near = Near { range :: Distance }
  data Far = Far { range :: Distance, age :: Time }
  
  doubled side = 2 * side.range
  
  error[E0311]: several types have a field `range`, and nothing determines which one you mean
   --> main.frob:4:25
    |
  4 | doubled side = 2 * side.range
    |                    ---- ^^^^^
    |                    |
    |                    the type of this is unknown
    |
    = note: types with such a field: `Far`, `Near`
    = hint: give the definition a signature
  
  1 error
