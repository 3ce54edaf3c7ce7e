  $ ../../explain/message.exe E0418
  main.frob:
  third :: Array n Float -> Float
  third xs = xs ! 2
  
  main :: SF (Array 2 Float) Float
  main = proc xs -> third xs
  
  error[E0418]: index 2 is out of range for an array of 2 elements
   --> main.frob:2:12
    |
  2 | third xs = xs ! 2
    |            ^^^^^^
  ...
  5 | main = proc xs -> third xs
    |                   -------- `third` is called here
    |
    = note: the indices are 0 to 1
  
  1 error
