  $ ../../explain/message.exe E0226
  main.frob:
  (low, high) = (0.2[m], 0.8[m])
  
  error[E0226]: a top-level definition defines one name, not a pattern
   --> main.frob:1:1
    |
  1 | (low, high) = (0.2[m], 0.8[m])
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: define each name separately, or match the pattern in a `let` or `where`
  
  1 error
