  $ ../../explain/message.exe E0221
  main.frob:
  data Reading = Reading Float[u] a
  
  error[E0221]: unit variable `u` is not a parameter of `Reading`
   --> main.frob:1:30
    |
  1 | data Reading = Reading Float[u] a
    |                              ^
    |
    = hint: declare it in brackets after the name: `Reading[u]`
  
  error[E0221]: type variable `a` is not a parameter of `Reading`
   --> main.frob:1:33
    |
  1 | data Reading = Reading Float[u] a
    |                                 ^
    |
    = hint: declare it after the name: `Reading a`
  
  2 errors
