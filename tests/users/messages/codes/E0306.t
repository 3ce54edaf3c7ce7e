  $ ../../explain/message.exe E0306
  main.frob:
  raised :: Float[u] -> Float[u]
  raised x = x + 1[m]
  
  error[E0306]: the signature allows any unit `u`, but the definition needs it to be `m`
   --> main.frob:2:16
    |
  1 | raised :: Float[u] -> Float[u]
    |           -------------------- `u` is any unit in the signature of `raised`
  2 | raised x = x + 1[m]
    |                ^^^^ this is `Float[m]`
    |
    = hint: if the definition is right, write the signature as `Float[m] -> Float[m]`
  
  1 error
