A plain number where one with a unit is needed: the literal is shown with it.

  $ cat > argument.frob <<'FROB'
  > import Control
  > main :: SF Float Float
  > main = lowPass 0.2
  > FROB
  $ frobc check argument.frob
  error[E0320]: expected the unit `s`, found none
   --> argument.frob:3:16
    |
  3 | main = lowPass 0.2
    |        ------- ^^^ this is `Float`
    |        |
    |        argument 1 of `lowPass` is `Time` (s)
    |
    = hint: write `0.2[s]` if that is its unit
  
  1 error
  [1]

  $ cat > operand.frob <<'FROB'
  > near, far :: Distance -> Bool
  > near x = x < 3
  > far x = 3 < x
  > FROB
  $ frobc check operand.frob
  error[E0320]: the operands of `<` have different units: `m` and `1`
   --> operand.frob:2:14
    |
  2 | near x = x < 3
    |          -   ^ this is `Float`
    |          |
    |          this is `Distance` (m)
    |
    = hint: write `3[m]` if that is its unit
  
  error[E0320]: the operands of `<` have different units: `1` and `m`
   --> operand.frob:3:13
    |
  3 | far x = 3 < x
    |         -   ^ this is `Distance` (m)
    |         |
    |         this is `Float`
    |
    = hint: write `3[m]` if that is its unit
  
  2 errors
  [1]
