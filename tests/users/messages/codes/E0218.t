  $ ../../explain/message.exe E0218
  main.frob:
  data Path = End | Step Distance Path
  
  error[E0218]: the data type `Path` contains itself
   --> main.frob:1:6
    |
  1 | data Path = End | Step Distance Path
    |      ^^^^
    |
    = note: every value has a fixed size, so a data type cannot be recursive
    = hint: use an array of a fixed size, such as `Array 8 Distance`; if the number of valid elements varies, keep their count in a second field
  
  1 error
