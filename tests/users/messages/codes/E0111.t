  $ ../../explain/message.exe E0111
  main.frob:
  double :: Float -> Float
  double x = 2.0 * (x + 0.0
  
  error[E0111]: this `(` is never closed
   --> main.frob:2:18
    |
  2 | double x = 2.0 * (x + 0.0
    |                  ^       - a `)` is probably missing here
    |
    = hint: write `(x + 0.0)`
  
  1 error
