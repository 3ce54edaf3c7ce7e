  $ ../../explain/message.exe E0346
  main.frob:
  f :: Float -> Float
  f x = y where
      y = x + y
  
  error[E0346]: `y` is used in its own definition
   --> main.frob:3:13
    |
  3 |     y = x + y
    |     -       ^ only the equations of a `proc` may be recursive
    |     |
    |     `y` is defined here
  
  1 error
