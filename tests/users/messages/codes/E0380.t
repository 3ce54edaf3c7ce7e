  $ ../../explain/message.exe E0380
  main.frob:
  foreign apply :: (Float -> Float) -> Float -> Float = "apply"
  
  error[E0380]: `apply` cannot give C a value of type `Float -> Float`
   --> main.frob:1:18
    |
  1 | foreign apply :: (Float -> Float) -> Float -> Float = "apply"
    |                  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: functions, signal functions and labels exist only at compile time
  
  1 error
