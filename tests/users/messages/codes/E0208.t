  $ ../../explain/message.exe E0208
  main.frob:
  width :: Distance
  width = 3[inch]
  
  error[E0208]: unknown unit `inch`
   --> main.frob:2:11
    |
  2 | width = 3[inch]
    |           ^^^^
    |
    = hint: write `0.0762[m]`, or declare the unit on a line of its own: `unit inch = 0.0254 m`
  
  1 error
