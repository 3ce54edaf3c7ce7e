  $ ../../explain/message.exe E0223
  main.frob:
  clip :: Order a => a -> a -> a
  clip high x = min high x
  
  error[E0223]: unknown type class `Order`
   --> main.frob:1:9
    |
  1 | clip :: Order a => a -> a -> a
    |         ^^^^^
    |
    = hint: did you mean `Ord`?
  
  1 error
