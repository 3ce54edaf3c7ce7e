Keywords and symbols of other languages around a definition.

  $ cat > from_import_star.frob <<'FROB'
  > from Robot import *
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 0))
  > FROB
  $ frobc check from_import_star.frob
  error[E0110]: Frob has no `from`
   --> from_import_star.frob:1:1
    |
  1 | from Robot import *
    | ^^^^
    |
    = hint: use `import Robot`
  
  1 error
  [1]

  $ cat > const_decl.frob <<'FROB'
  > import Robot
  > const speed = 0.3[m/s]
  > main = reactimateRobot (proc i -> roMake (setVelTR speed 0))
  > FROB
  $ frobc check const_decl.frob
  error[E0205]: unknown name `speed`
   --> const_decl.frob:3:52
    |
  2 | const speed = 0.3[m/s]
    | ----- this defines a function `const`
  3 | main = reactimateRobot (proc i -> roMake (setVelTR speed 0))
    |                                                    ^^^^^
    |
    = hint: remove `const` before `speed`
  
  1 error
  [1]

  $ cat > let_top.frob <<'FROB'
  > import Robot
  > let speed = 0.3[m/s]
  > main = reactimateRobot (proc i -> roMake (setVelTR speed 0))
  > FROB
  $ frobc check let_top.frob
  error[E0110]: a top-level definition cannot start with `let`
   --> let_top.frob:2:1
    |
  2 | let speed = 0.3[m/s]
    | ^^^
    |
    = hint: write `speed = 0.3[m/s]`
  
  1 error
  [1]

  $ cat > braces_if.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = if frontSonar i < 0.5[m] { 0 } else { 0.3[m/s] })
  > FROB
  $ frobc check braces_if.frob
  error[E0110]: expected the name of a field, found the number `0`
   --> braces_if.frob:3:36
    |
  3 |     v = if frontSonar i < 0.5[m] { 0 } else { 0.3[m/s] })
    |                                    ^
    |
    = hint: use `if frontSonar i < 0.5[m] then 0 else 0.3[m/s]`, without braces
  
  1 error
  [1]

  $ cat > type_annot_python.frob <<'FROB'
  > f (x: Float) = x * 2
  > main = proc x -> f x
  > FROB
  $ frobc check type_annot_python.frob
  error[E0103]: unexpected character `:`
   --> type_annot_python.frob:1:5
    |
  1 | f (x: Float) = x * 2
    |     ^
    |
    = hint: write the types in a signature on the line above, with the result last: `f :: Float -> Float`
  
  1 error
  [1]

  $ cat > arrow_return_type.frob <<'FROB'
  > f :: Float - > Float
  > f x = x * 2
  > main = proc x -> f x
  > FROB
  $ frobc check arrow_return_type.frob
  error[E0110]: expected `->` or the end of this type, found `-`
   --> arrow_return_type.frob:1:12
    |
  1 | f :: Float - > Float
    |            ^
    |
    = hint: remove the space from the arrow: `->`
  
  1 error
  [1]

  $ cat > sig_comma.frob <<'FROB'
  > f :: Float, Float -> Float
  > f x y = x * y
  > main = proc x -> f x x
  > FROB
  $ frobc check sig_comma.frob
  error[E0110]: expected `->` or the end of this type, found `,`
   --> sig_comma.frob:1:11
    |
  1 | f :: Float, Float -> Float
    |           ^
    |
    = hint: put `->` after each parameter, as in `Float -> Float -> Float`; put a tuple in parentheses
  
  1 error
  [1]

  $ cat > switch_arrow.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR 0.2[m/s] 0)
  > rest = proc i -> roMake (setVelTR 0 0)
  > main = reactimateRobot (drive `switch` bumped `then` rest)
  > FROB
  $ frobc check switch_arrow.frob
  error[E0110]: `then` is a reserved word, so it cannot be a name
   --> switch_arrow.frob:4:48
    |
  4 | main = reactimateRobot (drive `switch` bumped `then` rest)
    |                                                ^^^^
  
  1 error
  [1]

  $ cat > mode_state.frob <<'FROB'
  > data Mode = Drive | Turn
  > step :: Mode -> Bool -> Mode
  > step Drive True = Turn
  > step Drive False = Drive
  > step Turn _ = Drive
  > main = proc b -> m where
  >     m = step (delay Drive m) b
  > FROB
  $ frobc check mode_state.frob
  error[E0115]: `step` is defined by several clauses
   --> mode_state.frob:4:1
    |
  3 | step Drive True = Turn
    | ---- the first
  4 | step Drive False = Drive
    | ^^^^
  5 | step Turn _ = Drive
    | ---- one more
    |
    = hint: write one clause, `step x y = case (x, y) of`; on the lines below it, write a branch `pattern -> value` for each clause
  
  1 error
  [1]

  $ cat > case_eq.frob <<'FROB'
  > data Mode = Drive | Turn
  > speed :: Mode -> Float
  > speed m = case m of
  >     Drive = 1
  >     Turn = 0
  > main = proc m -> speed m
  > FROB
  $ frobc check case_eq.frob
  error[E0110]: expected `->` or a guard after this pattern, found `=`
   --> case_eq.frob:4:11
    |
  4 |     Drive = 1
    |           ^
    |
    = hint: use `->` in a branch: `Drive -> …`
  
  1 error
  [1]

  $ cat > data_fields_lower.frob <<'FROB'
  > data st = St { x :: Float }
  > main = proc v -> St { x = v }
  > FROB
  $ frobc check data_fields_lower.frob
  error[E0110]: expected the name of the new type, starting with a capital letter, found `st`
   --> data_fields_lower.frob:1:6
    |
  1 | data st = St { x :: Float }
    |      ^^
    |
    = hint: start the name of a type or class with a capital letter: `St`
  
  1 error
  [1]

  $ cat > param_no_default.frob <<'FROB'
  > import Robot
  > param speed :: Velocity
  > main = reactimateRobot (proc i -> roMake (setVelTR speed 0))
  > FROB
  $ frobc check param_no_default.frob
  error[E0110]: expected `=` and the default value of the parameter, found the end of the definition
   --> param_no_default.frob:2:24
    |
  2 | param speed :: Velocity
    |                        ^
    |
    = hint: add its default value: `param speed :: Velocity = …`
  
  1 error
  [1]

  $ cat > foreign_no_string.frob <<'FROB'
  > foreign cbrt :: Float -> Float
  > main = proc x -> cbrt x
  > FROB
  $ frobc check foreign_no_string.frob
  error[E0110]: expected `=` and the C name, in quotes, found the end of the definition
   --> foreign_no_string.frob:1:31
    |
  1 | foreign cbrt :: Float -> Float
    |                               ^
    |
    = hint: add its C name: `foreign cbrt :: Float -> Float = "cbrt"`
  
  1 error
  [1]

  $ cat > foreign_haskell.frob <<'FROB'
  > foreign import ccall "cbrt" cbrt :: Float -> Float
  > main = proc x -> cbrt x
  > FROB
  $ frobc check foreign_haskell.frob
  error[E0110]: `foreign` must not be followed by `import`, and the C name must come last
   --> foreign_haskell.frob:1:9
    |
  1 | foreign import ccall "cbrt" cbrt :: Float -> Float
    |         ^^^^^^
    |
    = hint: write `foreign cbrt :: Float -> Float = "cbrt"`
  
  1 error
  [1]

  $ cat > where_before_the_output.frob <<'FROB'
  > main = proc x where
  >     y = x + 1
  >   -> y
  > FROB
  $ frobc check where_before_the_output.frob
  error[E0110]: expected `->` after the input of this `proc`, found `where`
   --> where_before_the_output.frob:1:15
    |
  1 | main = proc x where
    |               ^^^^^
    |
    = hint: write the output before `where`: `proc x -> y where`
  
  1 error
  [1]

  $ cat > type_vs_data.frob <<'FROB'
  > type Mode = Go | Stop
  > main = proc v -> v
  > FROB
  $ frobc check type_vs_data.frob
  error[E0110]: expected a type argument, `->`, or the end of the type, found `|`
   --> type_vs_data.frob:1:16
    |
  1 | type Mode = Go | Stop
    |                ^
    |
    = hint: to declare a type with several constructors, use `data`: `data Mode = Go | Stop`
  
  1 error
  [1]

`implies` between two comparisons takes their results, but `min` takes the numbers:

  $ for e in 'v == 0 `implies` w == 0' 'v < 1 `min` w < 2'; do
  >   printf 'import Past\nmain :: SF (Float, Float) Float\nmain = proc (v, w) -> v where\n    assert "stops" (%s)\n' "$e" > chain.frob
  >   frobc check chain.frob 2>&1 | grep hint
  > done
    = hint: put parentheses around each comparison: ``(v == 0) `implies` (w == 0)``
    = hint: compare two values at a time: ``v < 1 `min` w && 1 `min` w < 2``
  $ sed 's/assert.*/assert "stops" ((v == 0) `implies` (w == 0))/' chain.frob > pasted.frob && frobc check pasted.frob
  $ sed -e 1d -e 's/assert.*/assert "stops" (v < 1 `min` w \&\& 1 `min` w < 2)/' chain.frob > pasted.frob && frobc check pasted.frob

Alternatives in braces, as in C:

  $ printf 'data Lamp = { Dark, Dim, Bright }\nmain :: SF Bool Lamp\nmain = proc on -> if on then Bright else Dim\n' > lamp.frob
  $ frobc check lamp.frob 2>&1 | grep hint
    = hint: write `|` between the constructors, without braces: `data Lamp = Dark | Dim | Bright`
  $ sed 's/^data.*/data Lamp = { Bright }/' lamp.frob > one.frob && frobc check one.frob 2>&1 | grep hint
    = hint: remove the braces: `data Lamp = Bright`
  $ sed 's/^data.*/data Lamp = Dark | Dim | Bright/' lamp.frob > pasted.frob && frobc check pasted.frob

A colon after a blank in a record:

  $ printf 'import Geometry\nmain :: SF () Point2\nmain = proc () -> Vec2 { x : 2[m], y : 1[m] }\n' > colon.frob
  $ frobc check colon.frob 2>&1 | grep hint
    = hint: set a field with `=`: `Vec2 { x = 2[m], y = 1[m] }`
  $ sed 's/Vec2 .*/Vec2 { x = 2[m], y = 1[m] }/' colon.frob > pasted.frob && frobc check pasted.frob

A decimal comma, but not in a call in the notation of C, or between values that are not whole numbers:

  $ for e in '2 * (d - 0,4[m])' '2 * (0,4[m])' 'abs(0,4[m])' '2 * (d - 1.5,4[m])' '2 * (d1,4[m])'; do
  >   printf 'main :: SF Float[m] Float[m]\nmain = proc d -> e where\n    d1 = d\n    e = %s\n' "$e" > comma.frob
  >   frobc check comma.frob 2>&1 | grep -e ^error -e hint
  > done
  error[E0301]: expected a number, found `(Float[m], n[m])`
    = hint: use a decimal point, because a comma makes a tuple: write `(d - 0.4[m])`
  error[E0301]: expected a number, found `(n[u], n1[m])`
    = hint: use a decimal point, because a comma makes a tuple: write `(0.4[m])`
  error[E0301]: expected a number, found a tuple with 2 elements
    = hint: `abs` takes one argument, not a tuple
  error[E0301]: expected a number, found `(_, n[m])`
  error[E0320]: the operands of `-` have different units: `m` and `1`
    = hint: write `1.5[m]` if that is the right unit
  error[E0301]: expected a number, found `(Float[m], n[m])`
  $ sed 's/ e = .*/ e = 2 * (d1 - 0.4[m])/' comma.frob > pasted.frob && frobc check pasted.frob
