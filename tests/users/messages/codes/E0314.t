  $ ../../explain/message.exe E0314
  main.frob:
  origin :: Distance -> (Distance, Time)
  origin d = (d + zero, 1[s] + zero) where
      zero :: Float[u]
      zero = 0
  
  error[E0314]: only a local function can be polymorphic, but `zero` is `Float[u]`
   --> main.frob:4:5
    |
  3 |     zero :: Float[u]
    |             -------- this signature has type variables of its own
  4 |     zero = 0
    |     ^^^^
  
  1 error
