  $ ../../explain/message.exe E0366
  main.frob:
  data Square = Square { side :: Float }
  
  instance Eq Square where
  
  error[E0366]: `Eq` has no declared instances
   --> main.frob:3:10
    |
  3 | instance Eq Square where
    |          ^^^^^^^^^
    |
    = note: the compiler compares all data without functions by structure
    = hint: remove the instance
  
  1 error
