  $ ../../explain/message.exe E0301
  main.frob:
  isNear :: Distance -> Bool
  isNear d = if d < 0.5[m] then 1 else 0
  
  error[E0301]: expected `Bool`, found a number
   --> main.frob:2:31
    |
  1 | isNear :: Distance -> Bool
    |           ---------------- the signature of `isNear` requires `Bool`
  2 | isNear d = if d < 0.5[m] then 1 else 0
    |                               ^
    |
    = hint: use `True`: a number is not a `Bool`
  
  1 error
