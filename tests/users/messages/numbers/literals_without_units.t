A number without a unit where one is required: the message shows the literal
with the unit.

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
    = hint: write `0.2[s]` if that is the right unit
  
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
    = hint: write `3[m]` if that is the right unit
  
  error[E0320]: the operands of `<` have different units: `1` and `m`
   --> operand.frob:3:13
    |
  3 | far x = 3 < x
    |         -   ^ this is `Distance` (m)
    |         |
    |         this is `Float`
    |
    = hint: write `3[m]` if that is the right unit
  
  2 errors
  [1]

In a record, the message shows the number, not the record.

  $ cat > corners.frob <<'FROB'
  > import Geometry
  > corners :: Array 2 Point2
  > corners = [Vec2 { x = 0, y = 0 }, Vec2 { x = 10, y = 0 }]
  > 
  > home :: Pose
  > home = Pose { position = Vec2 { x = 1, y = 2[m] }, heading = 90[deg] }
  > 
  > scaled :: Float[u] -> Vec2[u]
  > scaled k = Vec2 { x = k, y = 1 }
  > FROB
  $ frobc check corners.frob
  error[E0320]: expected the unit `m`, found none
   --> corners.frob:3:46
    |
  3 | corners = [Vec2 { x = 0, y = 0 }, Vec2 { x = 10, y = 0 }]
    |                                          -   ^^ this is `Float`
    |                                          |
    |                                          the field `x` is `Float[m]`
    |
    = hint: write `10[m]` if that is the right unit
  
  error[E0320]: expected the unit `m`, found none
   --> corners.frob:6:37
    |
  6 | home = Pose { position = Vec2 { x = 1, y = 2[m] }, heading = 90[deg] }
    |                                 -   ^ this is `Float`
    |                                 |
    |                                 the field `x` is `Float[m]`
    |
    = hint: write `1[m]` if that is the right unit
  
  error[E0306]: the signature allows any unit `u`, but the definition needs it to be `1`
   --> corners.frob:9:30
    |
  8 | scaled :: Float[u] -> Vec2[u]
    |           ------------------- `u` is any unit in the signature of `scaled`
  9 | scaled k = Vec2 { x = k, y = 1 }
    |                              ^ this is `Float`
    |
    = hint: if the definition is right, write the signature as `Float[1] -> Vec2[1]`
  
  3 errors
  [1]
