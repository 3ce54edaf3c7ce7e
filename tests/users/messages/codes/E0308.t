  $ ../../explain/message.exe E0308
  main.frob:
  quiet :: Bool
  quiet = NoEvent == NoEvent
  
  error[E0308]: nothing determines the type at which `==` is used
   --> main.frob:2:17
    |
  2 | quiet = NoEvent == NoEvent
    |                 ^^
    |
    = note: the type must have an instance of the class `Eq`
    = hint: add a type annotation, as in `(e :: T)`
  
  1 error
