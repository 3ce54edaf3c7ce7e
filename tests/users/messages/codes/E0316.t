  $ ../../explain/message.exe E0316
  main.frob:
  both :: a -> (a, a)
  both x = (x, x)
  
  many x = both (both (both (both (both (both (both (both (both (both (both (both (both (both (both (both x)))))))))))))))
  
  error[E0316]: the type of this expression is too large
   --> main.frob:4:28
    |
  4 | many x = both (both (both (both (both (both (both (both (both (both (both (both (both (both (both (both x)))))))))))))))
    |                            ^^^^
    |
    = note: a type can have at most 20000 parts, nested at most 500 levels deep
  
  1 error
