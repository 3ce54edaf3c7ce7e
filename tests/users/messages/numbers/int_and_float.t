Int and Float in one operation: the message names both operands, and the conversion.

  $ cat > product.frob <<'FROB'
  > double :: Int -> Float
  > double n = 2.0 * n
  > FROB
  $ frobc check product.frob
  error[E0312]: the operands of `*` are `Float` and `Int`
   --> product.frob:2:18
    |
  2 | double n = 2.0 * n
    |            ---   ^ this is `Int`
    |            |
    |            this is `Float`
    |
    = hint: write `toFloat n`
  
  1 error
  [1]

  $ cat > sum.frob <<'FROB'
  > f :: Int -> Float[m] -> Float[m]
  > f n x = n + x
  > FROB
  $ frobc check sum.frob
  error[E0312]: the operands of `+` are `Int` and `Float[m]`
   --> sum.frob:2:13
    |
  2 | f n x = n + x
    |         -   ^ this is `Float[m]`
    |         |
    |         this is `Int`
    |
    = hint: write `toFloat n`
  
  1 error
  [1]

  $ cat > half.frob <<'FROB'
  > half :: Int -> Int
  > half n = n / 2
  > FROB
  $ frobc check half.frob
  error[E0312]: expected `Float`, found `Int`
   --> half.frob:2:10
    |
  2 | half n = n / 2
    |          ^ - argument 1 of `/` is `Float`
    |
    = hint: for a whole number, write `div n 2`, which rounds down; for a number with a fraction, write `toFloat n / 2`
  
  1 error
  [1]

A type in lower case is a variable.

  $ cat > lower.frob <<'FROB'
  > f :: float -> float
  > f x = x + 1
  > FROB
  $ frobc check lower.frob
  error[E0306]: the signature allows any type `float`, but the definition needs it to be a number
   --> lower.frob:2:7
    |
  1 | f :: float -> float
    |      -------------- `float` is any type in the signature of `f`
  2 | f x = x + 1
    |       ^
    |
    = hint: if you meant the type, write `Float -> Float`; a lower-case name means any type
  
  1 error
  [1]
