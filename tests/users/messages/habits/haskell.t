Haskell's constructs that Frob writes differently, or that only look alike.

A type of one constructor is `data`:

  $ echo 'newtype Metres = Metres Float' > newtype.frob
  $ frobc check newtype.frob
  error[E0112]: Frob has no `newtype`
   --> newtype.frob:1:1
    |
  1 | newtype Metres = Metres Float
    | ^^^^^^^
    |
    = hint: use `data`: it has no overhead for a single field
  
  1 error
  [1]

As in Haskell, application binds tighter than operators:

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
    = hint: put parentheses around the argument, because function application binds tighter than `>`: `not (x > …)`
  
  error[E0301]: expected `Bool`, found `Float`
   --> application.frob:5:23
    |
  5 | near = proc x -> when x < 3
    |                  ---- ^
    |                  |
    |                  argument 1 of `when` is `Bool`
    |
    = hint: put parentheses around the argument, because function application binds tighter than `<`: `when (x < …)`
  
  error[E0301]: expected `Bool`, found a number
   --> application.frob:8:30
    |
  8 | both = proc b -> if b && not x < 3 then 1 else 2 where
    |                          --- ^
    |                          |
    |                          argument 1 of `not` is `Bool`
    |
    = hint: put parentheses around the argument, because function application binds tighter than `<`: `not (x < …)`
  
  3 errors
  [1]

If an argument determines a type, the message shows it there:

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
    |
    = hint: `0` is not a `Bool`: write `delay False b`
  
  error[E0301]: expected `SF (Event Bool) Bool`, found `SF (Event n[u]) n[u]`
   --> decided.frob:5:8
    |
  4 | kept :: SF (Event Bool) Bool
    |         -------------------- the signature of `kept` requires `SF (Event Bool) Bool`
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
    |
    = hint: the signature is `hold :: a -> SF (Event a) a`
  
  error[E0301]: expected `Maybe n[u]`, found `Maybe Bool`
    --> decided.frob:11:26
     |
  11 | fallback m = fromMaybe 0 m
     |              --------- - ^
     |              |         |
     |              |         because this is a number
     |              argument 2 of `fromMaybe` is `Maybe n[u]`
     |
     = hint: the signature is `fromMaybe :: a -> Maybe a -> a`
  
  4 errors
  [1]

A field is not a function:

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
    = note: `speed` is a field of `Wheel`: write `r.speed`, or `\r -> r.speed` if you need a function, or `proc r -> r.speed` if you need a signal function
    = hint: did you mean `speeds`?
  
  1 error
  [1]

A type in lower case is a variable. If that does no harm, it is a warning:

  $ cat > lower_case.frob <<'FROB'
  > twice :: float[m] -> float[m]
  > twice x = x + x
  > 
  > half :: float[m] -> float[m]
  > half x = x / 2
  > FROB
  $ frobc check lower_case.frob
  error[E0306]: the signature allows any representation `float`, but the definition needs it to be `Float`
   --> lower_case.frob:5:10
    |
  4 | half :: float[m] -> float[m]
    |         -------------------- `float` is any representation in the signature of `half`
  5 | half x = x / 2
    |          ^
    |
    = hint: if you meant the type, write `Float[m] -> Float[m]`; a lower-case name means any representation
  
  warning[W0302]: `float` is a type variable here, so it means any type
   --> lower_case.frob:1:10
    |
  1 | twice :: float[m] -> float[m]
    |          ^^^^^^^^^^^^^^^^^^^^
    |
    = hint: if you meant the type, write `Float`
  
  1 error, 1 warning
  [1]

Operators that only Haskell has, and its other syntax for a list, a branch and a module.

  $ cat > bind.frob <<'FROB'
  > import Robot
  > go = sleepT 1[s] (roMake (setVelTR 0.3[m/s] 0)) >>= \_ -> go
  > FROB
  $ frobc check bind.frob
  error[E0110]: Frob has no `>>=`
   --> bind.frob:2:49
    |
  2 | go = sleepT 1[s] (roMake (setVelTR 0.3[m/s] 0)) >>= \_ -> go
    |                                                 ^^^
    |
    = hint: write each task on its own line in a `do`
  
  1 error
  [1]

  $ cat > join.frob <<'FROB'
  > main :: SF Float String
  > main = proc x -> "x = " ++ show x
  > FROB
  $ frobc check join.frob
  error[E0110]: Frob has no `++`
   --> join.frob:2:25
    |
  2 | main = proc x -> "x = " ++ show x
    |                         ^^
    |
    = hint: strings and arrays cannot be concatenated: a string is a label, and an array has a fixed size
  
  1 error
  [1]

  $ cat > index.frob <<'FROB'
  > f :: Array 3 Float -> Float
  > f xs = xs !! 0
  > FROB
  $ frobc check index.frob
  error[E0110]: Frob has no `!!`
   --> index.frob:2:11
    |
  2 | f xs = xs !! 0
    |           ^^
    |
    = hint: for a constant index, use `xs ! 0`; for any index, use `at i x xs`, which returns `x` if there is no such element
  
  1 error
  [1]

  $ cat > range.frob <<'FROB'
  > xs :: Array 4 Int
  > xs = [1..4]
  > FROB
  $ frobc check range.frob
  error[E0110]: Frob has no `..`
   --> range.frob:2:8
    |
  2 | xs = [1..4]
    |        ^^
    |
    = hint: Frob has no ranges: write the elements, `[1, 2, 3, 4]`
  
  1 error
  [1]

  $ cat > branch.frob <<'FROB'
  > data M = A | B
  > f :: M -> Float
  > f m = case m of
  >     A => 1.0
  >     B => 2.0
  > FROB
  $ frobc check branch.frob
  error[E0110]: expected an operator, an argument, or the end of the expression, found `=>`
   --> branch.frob:4:7
    |
  4 |     A => 1.0
    |       ^^
    |
    = hint: use `->` in a branch: `A -> 1.0`
  
  1 error
  [1]

  $ cat > module.frob <<'FROB'
  > import Data.Maybe
  > main = identity
  > FROB
  $ frobc check module.frob
  error[E0110]: expected the name of a module, starting with a capital letter, found `Data.Maybe`
   --> module.frob:1:8
    |
  1 | import Data.Maybe
    |        ^^^^^^^^^^
    |
    = hint: remove the import: functions such as `map`, `foldl` and `maybe` are built in; other modules of the library are `Control`, `Geometry` and `Robot`
  
  1 error
  [1]

For names from Haskell, Yampa and C, the message names Frob's equivalent.

  $ cat > names.frob <<'FROB'
  > main :: SF Int Float
  > main = proc n -> fromIntegral n + product [1.0] + fromJust None where
  >     a = iPre 0 n
  >     b = lMerge NoEvent NoEvent
  >     c = fmap id NoEvent
  >     d = pow 2 3
  >     e = stop
  > FROB
  $ frobc check names.frob
  error[E0205]: unknown name `fromIntegral`
   --> names.frob:2:18
    |
  2 | main = proc n -> fromIntegral n + product [1.0] + fromJust None where
    |                  ^^^^^^^^^^^^
    |
    = hint: write `toFloat n`
  
  error[E0205]: unknown name `product`
   --> names.frob:2:35
    |
  2 | main = proc n -> fromIntegral n + product [1.0] + fromJust None where
    |                                   ^^^^^^^
    |
    = hint: use `foldl (*) 1 xs` to multiply the elements of an array
  
  error[E0205]: unknown name `fromJust`
   --> names.frob:2:51
    |
  2 | main = proc n -> fromIntegral n + product [1.0] + fromJust None where
    |                                                   ^^^^^^^^
    |
    = hint: use `fromMaybe x m`, where `x` is the default for a missing value
  
  error[E0206]: unknown constructor `None`
   --> names.frob:2:60
    |
  2 | main = proc n -> fromIntegral n + product [1.0] + fromJust None where
    |                                                            ^^^^
    |
    = hint: write `Nothing`
  
  error[E0205]: unknown name `iPre`
   --> names.frob:3:9
    |
  3 |     a = iPre 0 n
    |         ^^^^
    |
    = hint: write `delay 0 n`, where 0 is the value at the first instant
  
  error[E0205]: unknown name `lMerge`
   --> names.frob:4:9
    |
  4 |     b = lMerge NoEvent NoEvent
    |         ^^^^^^
    |
    = hint: write `mergeE`
  
  error[E0205]: unknown name `fmap`
   --> names.frob:5:9
    |
  5 |     c = fmap id NoEvent
    |         ^^^^
    |
    = hint: use `map` for arrays, `mapE` for events, and `mapT` for the results of tasks
  
  error[E0205]: unknown name `pow`
   --> names.frob:6:9
    |
  6 |     d = pow 2 3
    |         ^^^
    |
    = hint: write `2 ^ 3`
  
  error[E0205]: unknown name `stop`
   --> names.frob:7:9
    |
  7 |     e = stop
    |         ^^^^
    |
    = hint: to stop the robot, use the output `restingOutput`; in a task, `sleepT 1[s] restingOutput` stops it for 1 s
  
  9 errors
  [1]
