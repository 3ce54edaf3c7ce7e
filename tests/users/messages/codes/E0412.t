  $ ../../explain/message.exe E0412
  main.frob:
  main :: SF Float Float
  main = proc x -> f x where
      f = delay id g
      g y = x + y
  
  error[E0412]: a value of type `Float -> Float` cannot be stored in a `delay`
   --> main.frob:3:5
    |
  3 |     f = delay id g
    |     ^^^^^^^^^^^^^^
    |
    = note: functions, signal functions and labels only exist at compile time
  
  1 error
