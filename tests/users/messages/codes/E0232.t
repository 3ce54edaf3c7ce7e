  $ ../../explain/message.exe E0232
  main.frob:
  foreign cubeRoot :: Float -> Float = "math.h cbrt"
  
  error[E0232]: `math.h cbrt` is not a name in C
   --> main.frob:1:38
    |
  1 | foreign cubeRoot :: Float -> Float = "math.h cbrt"
    |                                      ^^^^^^^^^^^^^
    |
    = hint: write only the name of the function, as in `"cbrt"`
  
  1 error
