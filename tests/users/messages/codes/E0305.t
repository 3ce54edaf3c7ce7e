  $ ../../explain/message.exe E0305
  main.frob:
  twice f x = f (f, x)
  
  error[E0305]: this would need an infinite type: expected `(a, b) -> c`, found `a`
   --> main.frob:1:13
    |
  1 | twice f x = f (f, x)
    |       -     ^
    |       |
    |       `f` is bound here
  
  1 error
