  $ ../../explain/message.exe E0212
  main.frob:
  double :: SF Float Float
  double = proc x -> y where
      y = x
      y = y + x
  
  error[E0212]: `y` is defined twice here
   --> main.frob:4:5
    |
  3 |     y = x
    |     - first defined here
  4 |     y = y + x
    |     ^
    |
    = hint: write one equation, `y = x + x`, because an equation holds at every instant, unlike an assignment
  
  1 error
