  $ ../../explain/message.exe E0392
  main.frob:
  import Trial
  
  test "counts backwards" = during (0 - 1[s]) (proc () -> True)
  
  error[E0392]: a test must last more than 0 s and at most 100,000 s, but this one lasts -1 s
   --> main.frob:3:1
    |
  3 | test "counts backwards" = during (0 - 1[s]) (proc () -> True)
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  
  1 error
