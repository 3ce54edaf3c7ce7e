Units that do not fit are shown as in the program, with the names of aliases, at
both places.

  $ cat > operands.frob <<FROB
  > vMax :: Velocity
  > vMax = 0.4[m/s]
  > 
  > ahead :: Distance -> Distance
  > ahead d = d + vMax
  > FROB
  $ frobc check operands.frob
  error[E0320]: the operands of `+` have different units: `m` and `m/s`
   --> operands.frob:5:15
    |
  5 | ahead d = d + vMax
    |           -   ^^^^ this is `Velocity` (m/s)
    |           |
    |           this is `Distance` (m)
    |
    = hint: multiply by a time, as in `1[s] * vMax`, or, for the sum over time, write `integral vMax`
  
  1 error
  [1]

The second branch must agree with the first one.

  $ cat > branches.frob <<FROB
  > near :: Distance -> Velocity -> Bool -> Distance
  > near d v far = 2.0 * (if far then d else v)
  > FROB
  $ frobc check branches.frob
  error[E0320]: expected the unit `m`, found `m/s`
   --> branches.frob:2:42
    |
  2 | near d v far = 2.0 * (if far then d else v)
    |                                   -      ^ this is `Velocity` (m/s)
    |                                   |
    |                                   this branch is `Distance` (m)
    |
    = hint: multiply by a time, as in `1[s] * v`, or, for the sum over time, write `integral v`
  
  1 error
  [1]

An argument is compared with the signature of the function, and a component with
its part of the signature.

  $ cat > signatures.frob <<FROB
  > stop :: Velocity -> Float[m/s^2] -> Time
  > stop v a = v / a
  > 
  > brake :: Distance -> Velocity -> (Time, Time)
  > brake d v = (stop d 2.0[m/s^2], v)
  > FROB
  $ frobc check signatures.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> signatures.frob:5:19
    |
  4 | brake :: Distance -> Velocity -> (Time, Time)
    |          -------- the signature gives `d` this type
  5 | brake d v = (stop d 2.0[m/s^2], v)
    |              ---- ^ this is `Distance` (m)
    |              |
    |              argument 1 of `stop` is `Velocity` (m/s)
    |
    = hint: if `d` is of type `Velocity`, write the signature as `brake :: Velocity -> Velocity -> (Time, Time)`
    = hint: multiply by a gain, as in `0.5[1/s] * d`, or, for the rate of change, write `derivative d`
  
  error[E0320]: expected the unit `s`, found `m/s`
   --> signatures.frob:5:33
    |
  4 | brake :: Distance -> Velocity -> (Time, Time)
    |          ------------------------------------ by the signature of `brake`, the second component is `Time` (s)
  5 | brake d v = (stop d 2.0[m/s^2], v)
    |                                 ^ this is `Velocity` (m/s)
    |
    = hint: if this is the right result, write `Velocity` in the signature
  
  2 errors
  [1]

Units with their own names keep them; wrong roots and powers are shown.

  $ cat > named.frob <<FROB
  > force :: Float[kg] -> Float[m/s^2] -> Float[N]
  > force m a = m * a + 2.0[J]
  > 
  > side :: Float[m^2] -> Distance
  > side area = area / 2
  > FROB
  $ frobc check named.frob
  error[E0320]: the operands of `+` have different units: `N` and `J`
   --> named.frob:2:21
    |
  2 | force m a = m * a + 2.0[J]
    |             -----   ^^^^^^ this is `Float[J]`
    |             |
    |             this is `Float[N]`
    |
    = hint: write `2.0[N]` if you meant that unit
  
  error[E0320]: expected the unit `m`, found `m^2`
   --> named.frob:5:13
    |
  4 | side :: Float[m^2] -> Distance
    |         ---------------------- the signature of `side` requires `Distance` (m)
  5 | side area = area / 2
    |             ^^^^^^^^ this is `Float[m^2]`
    |
    = hint: write `sqrt (area / 2)`, which has the expected unit
    = hint: if this is the right result, write the signature as `side :: Float[m^2] -> Float[m^2]`
  
  2 errors
  [1]

A signature that claims every unit although the definition works only for one,
or for a related one.

  $ cat > general.frob <<FROB
  > raised :: Float[u] -> Float[u]
  > raised x = x + 1[m]
  > 
  > square :: Float[u] -> Float[u]
  > square x = x * x
  > FROB
  $ frobc check general.frob
  error[E0306]: the signature allows any unit `u`, but the definition needs it to be `m`
   --> general.frob:2:16
    |
  1 | raised :: Float[u] -> Float[u]
    |           -------------------- `u` is any unit in the signature of `raised`
  2 | raised x = x + 1[m]
    |                ^^^^ this is `Float[m]`
    |
    = hint: if the definition is right, write the signature as `Float[m] -> Float[m]`
  
  error[E0320]: expected the unit `u`, found `u^2`
   --> general.frob:5:12
    |
  4 | square :: Float[u] -> Float[u]
    |           -------------------- the signature of `square` requires `Float[u]`
  5 | square x = x * x
    |            ^^^^^ this is `Float[u^2]`
    |
    = hint: for the square root, write `sqrt (x * x)`
    = hint: if this is the right result, write the signature as `square :: Float[u] -> Float[u^2]`
  
  2 errors
  [1]

One mistake has one message, however often the definition is used.

  $ cat > once.frob <<FROB
  > pace = 1[m] + 1[s]
  > twice = 2 * pace
  > run :: SF () Distance
  > run = proc () -> twice * time () + integral pace
  > FROB
  $ frobc check once.frob
  error[E0320]: the operands of `+` have different units: `m` and `s`
   --> once.frob:1:15
    |
  1 | pace = 1[m] + 1[s]
    |        ----   ^^^^ this is a number in `s`
    |        |
    |        this is a number in `m`
    |
    = hint: write `1[m]` if you meant that unit
  
  1 error
  [1]
