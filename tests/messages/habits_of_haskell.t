What Haskell has and Frob writes otherwise, or only looks alike.

A type of one constructor is `data`:

  $ echo 'newtype Metres = Metres Float' > newtype.frob
  $ frobc check newtype.frob
  error[E0112]: `newtype` is not part of this version of Frob
   --> newtype.frob:1:1
    |
  1 | newtype Metres = Metres Float
    | ^^^^^^^
    |
    = hint: `data` makes a new type, and one with a single field costs nothing
  
  1 error
  [1]

Application binds tighter than operators, here as there:

  $ cat > application.frob <<'FROB'
  > outside :: Float -> Bool
  > outside x = not x > 0
  > 
  > near :: SF Float (Event ())
  > near = proc x -> when x < 3
  > 
  > both :: SF Bool Float
  > both = proc b -> if b && not x < 3 then 1 else 2 where
  >     x = if b then 1 else 2
  > FROB
  $ frobc check application.frob
  error[E0301]: expected `Bool`, found `Float`
   --> application.frob:2:17
    |
  2 | outside x = not x > 0
    |             --- ^
    |             |
    |             argument 1 of `not` is `Bool`
    |
    = hint: application binds tighter than `>`: write `not (… > …)`
  
  error[E0301]: expected `Bool`, found `Float`
   --> application.frob:5:23
    |
  5 | near = proc x -> when x < 3
    |                  ---- ^
    |                  |
    |                  argument 1 of `when` is `Bool`
    |
    = hint: application binds tighter than `<`: write `when (… < …)`
  
  error[E0301]: expected `Bool`, found a number
   --> application.frob:8:30
    |
  8 | both = proc b -> if b && not x < 3 then 1 else 2 where
    |                          --- ^
    |                          |
    |                          argument 1 of `not` is `Bool`
    |
    = hint: application binds tighter than `<`: write `not (… < …)`
  
  3 errors
  [1]

What an argument makes of a type is said where it is:

  $ cat > decided.frob <<'FROB'
  > before :: SF Bool Bool
  > before = proc b -> delay 0 b
  > 
  > kept :: SF (Event Bool) Bool
  > kept = hold 0
  > 
  > shown :: SF (Event Bool) Float
  > shown = proc e -> hold 0 e
  > 
  > fallback :: Maybe Bool -> Float
  > fallback m = fromMaybe 0 m
  > FROB
  $ frobc check decided.frob
  error[E0301]: expected a number, found `Bool`
   --> decided.frob:2:28
    |
  2 | before = proc b -> delay 0 b
    |                    ----- - ^
    |                    |     |
    |                    |     because this is a number
    |                    argument 2 of `delay` is a number
  
  error[E0301]: expected `SF (Event Bool) Bool`, found `SF (Event n[u]) n[u]`
   --> decided.frob:5:8
    |
  4 | kept :: SF (Event Bool) Bool
    |         -------------------- the signature of `kept` asks for `SF (Event Bool) Bool`
  5 | kept = hold 0
    |        ^^^^^^
  
  error[E0301]: expected `Event n[u]`, found `Event Bool`
   --> decided.frob:8:26
    |
  8 | shown = proc e -> hold 0 e
    |                   ---- - ^
    |                   |    |
    |                   |    because this is a number
    |                   argument 2 of `hold` is `Event n[u]`
  
  error[E0301]: expected `Maybe n[u]`, found `Maybe Bool`
    --> decided.frob:11:26
     |
  11 | fallback m = fromMaybe 0 m
     |              --------- - ^
     |              |         |
     |              |         because this is a number
     |              argument 2 of `fromMaybe` is `Maybe n[u]`
  
  4 errors
  [1]

A mode that goes on as itself is a definition at the top level:

  $ cat > local.frob <<'FROB'
  > counting :: SF Float Float
  > counting = go 0 where
  >     go v = switch (proc x -> (x + v, edge (x > 0))) (\_ -> go (v + 1))
  > FROB
  $ frobc check local.frob
  error[E0346]: `go` is used in its own definition
   --> local.frob:3:60
    |
  3 |     go v = switch (proc x -> (x + v, edge (x > 0))) (\_ -> go (v + 1))
    |     --                                                     ^^ functions may not call themselves
    |     |
    |     `go` is defined here
    |
    = hint: at the top level a signal function may go on as itself through a switch: define `go` there
  
  1 error
  [1]

A field is no function:

  $ cat > field.frob <<'FROB'
  > data Wheel = Wheel { speed :: Velocity }
  > speeds :: Array 4 Wheel -> Array 4 Velocity
  > speeds wheels = map speed wheels
  > FROB
  $ frobc check field.frob
  error[E0205]: unknown name `speed`
   --> field.frob:3:21
    |
  3 | speeds wheels = map speed wheels
    |                     ^^^^^
    |
    = note: `speed` is a field: `r.speed` reads it, and the function is `\r -> r.speed`
    = hint: did you mean `speeds`?
  
  1 error
  [1]

A type in lower case is a variable. Where that does no harm it is a warning:

  $ cat > lower_case.frob <<'FROB'
  > twice :: float[m] -> float[m]
  > twice x = x + x
  > 
  > half :: float[m] -> float[m]
  > half x = x / 2
  > FROB
  $ frobc check lower_case.frob
  warning[W0302]: `float` is a variable here, and stands for every type
   --> lower_case.frob:1:10
    |
  1 | twice :: float[m] -> float[m]
    |          ^^^^^^^^^^^^^^^^^^^^
    |
    = hint: the type is `Float`
  
  error[E0306]: the signature promises every representation `float`, but the definition needs it to be `Float`
   --> lower_case.frob:5:10
    |
  4 | half :: float[m] -> float[m]
    |         -------------------- `float` is any representation in the signature of `half`
  5 | half x = x / 2
    |          ^
    |
    = hint: the type is `Float`; a name in lower case stands for every representation
  
  1 error, 1 warning
  [1]
