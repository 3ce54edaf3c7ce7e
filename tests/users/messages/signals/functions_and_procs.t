A function or signal function that does not begin like one.

  $ cat > function.frob <<'FROB'
  > f :: Float -> Float
  > f = x -> x + 1
  > FROB
  $ frobc check function.frob
  error[E0110]: expected an operator, an argument, or the end of this definition, found `->`
   --> function.frob:2:7
    |
  2 | f = x -> x + 1
    |       ^^
    |
    = hint: write an anonymous function as `\x -> x + 1`, or a signal function as `proc x -> …`
  
  1 error
  [1]

  $ cat > lambda.frob <<'FROB'
  > f :: Float -> Float
  > f = \x = x + 1
  > FROB
  $ frobc check lambda.frob
  error[E0110]: expected `->` or another parameter, found `=`
   --> lambda.frob:2:8
    |
  2 | f = \x = x + 1
    |        ^
    |
    = hint: write `->` between the input and the output; `=` is for equations
  
  1 error
  [1]

  $ cat > proc.frob <<'FROB'
  > main :: SF (Float, Float) Float
  > main = proc a b -> a
  > FROB
  $ frobc check proc.frob
  error[E0110]: expected `->` after the input of this `proc`, found `b`
   --> proc.frob:2:15
    |
  2 | main = proc a b -> a
    |               ^
    |
    = hint: a `proc` has one input: use a tuple, `proc (a, b) -> …`
  
  1 error
  [1]

  $ cat > case.frob <<'FROB'
  > f :: Bool -> Float
  > f x = case x
  >     True -> 1
  >     False -> 0
  > FROB
  $ frobc check case.frob
  error[E0110]: expected `of` after the expression of the `case`, found `->`
   --> case.frob:3:10
    |
  2 | f x = case x
    |       ---- this `case`
  3 |     True -> 1
    |          ^^
    |
    = hint: end the line of the `case` with `of`: `case x of`
  
  1 error
  [1]

The statements of a `proc` are in a single `do`; a nested `do` contains tasks.

  $ cat > within.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> do
  >     y <- delay 0 -< x
  >     do
  >         z <- delay 0 -< y
  >         returnA -< z
  > FROB
  $ frobc check within.frob
  error[E0116]: `-<` is only allowed in the `do` of a `proc`
   --> within.frob:6:9
    |
  4 |     do
    |     -- this `do` does not directly follow `proc … ->`, so its statements are tasks
  5 |         z <- delay 0 -< y
  6 |         returnA -< z
    |         ^^^^^^^^^^^^
    |
    = hint: for a signal function, write all statements in one `do` after `proc x ->`; a task needs no `-<`
  
  1 error
  [1]
  $ cat > chosen.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> do
  >     y <- delay 0 -< x
  >     if y > 0
  >       then do
  >         returnA -< y
  >       else returnA -< x
  > FROB
  $ frobc check chosen.frob
  error[E0116]: a branch of a `proc` cannot contain commands
   --> chosen.frob:6:9
    |
  5 |       then do
    |            -- this `do` is in a branch
  6 |         returnA -< y
    |         ^^^^^^^^^^^^
    |
    = hint: choose the value: `returnA -< if c then a else b`
  
  1 error
  [1]
