  $ ../../explain/message.exe W0302
  main.frob:
  twice :: float[m] -> float[m]
  twice x = x + x
  
  warning[W0302]: `float` is a type variable here, so it means any type
   --> main.frob:1:10
    |
  1 | twice :: float[m] -> float[m]
    |          ^^^^^^^^^^^^^^^^^^^^
    |
    = hint: if you meant the type, write `Float`
  
  1 warning
