  $ ../../explain/message.exe E0390
  main.frob:
  param gains :: (Float[1/s], Float[1/m]) = (2[1/s], 4[1/m])
  
  error[E0390]: the parameter `gains` cannot have the type `(Float[1/s], Float[1/m])`
   --> main.frob:1:1
    |
  1 | param gains :: (Float[1/s], Float[1/m]) = (2[1/s], 4[1/m])
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: a parameter must be a number or a `Bool`, so that the command line can set it
    = hint: declare a separate parameter for each number in this value; for a choice, use a `Bool` or an `Int`
  
  1 error
