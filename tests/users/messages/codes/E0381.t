  $ ../../explain/message.exe E0381
  main.frob:
  foreign area :: Float -> Float -> Float = "area"
  foreign areaOf :: Int -> Int -> Int = "area"
  
  error[E0381]: the C function `area` is imported here with the type `Int -> Int -> Int`
   --> main.frob:2:9
    |
  1 | foreign area :: Float -> Float -> Float = "area"
    |         ---- and here with the type `Float -> Float -> Float`
  2 | foreign areaOf :: Int -> Int -> Int = "area"
    |         ^^^^^^
    |
    = note: a C function has one type
  
  1 error
