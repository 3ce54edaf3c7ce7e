  $ ../../explain/message.exe E0505
  main.frob:
  foreign cubeRoot :: Float -> Float = "cbrt"
  
  main :: SF Float Float
  main = arr cubeRoot
  
  error[E0505]: the interpreter cannot run this program: `cubeRoot` is written in C
   --> main.frob:1:9
    |
  1 | foreign cubeRoot :: Float -> Float = "cbrt"
    |         ^^^^^^^^
    |
    = hint: run it with `--engine c`
  
  1 error
