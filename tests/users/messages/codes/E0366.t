  $ ../../explain/message.exe E0366
  main.frob:
  data Square = Square { side :: Float }
  
  instance Eq Square where
  
  error[E0366]: you cannot declare an instance of `Eq`
   --> main.frob:3:10
    |
  3 | instance Eq Square where
    |          ^^^^^^^^^
    |
    = note: the compiler already compares all values by structure, except those that contain functions
    = hint: remove the instance
  
  1 error
