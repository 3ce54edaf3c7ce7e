  $ ../../explain/message.exe E0117
  main.frob:
  power :: Float -> Float -> Float
  power x y = x ^ y
  
  error[E0117]: the exponent of `^` must be a literal whole number
   --> main.frob:2:17
    |
  2 | power x y = x ^ y
    |                 ^
    |
    = hint: for other exponents, use `**`, which takes Floats without a unit; for an Int `n`, write `x ** toFloat n`
  
  1 error
