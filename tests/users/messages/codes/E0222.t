  $ ../../explain/message.exe E0222
  main.frob:
  data Range[u] = Range n[u] n[u]
  
  error[E0222]: `n` can be a Float or an Int, but `Range` has no parameter that decides which
   --> main.frob:1:23
    |
  1 | data Range[u] = Range n[u] n[u]
    |                       ^
    |
    = hint: write `Float[…]` or `Int[…]`, or make the whole type a parameter
  
  error[E0222]: `n` can be a Float or an Int, but `Range` has no parameter that decides which
   --> main.frob:1:28
    |
  1 | data Range[u] = Range n[u] n[u]
    |                            ^
    |
    = hint: write `Float[…]` or `Int[…]`, or make the whole type a parameter
  
  2 errors
