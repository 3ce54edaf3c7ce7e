Mistakes in first programs.

Blocks in braces, and a lambda, a field or a unit in the syntax of other
languages:

  $ cat > braces.frob <<'FROB'
  > avoid = proc i -> {
  >     x = i
  > }
  > FROB
  $ frobc check braces.frob
  error[E0110]: expected the output of this `proc`, or `do`, after `->`, found `{`
   --> braces.frob:1:19
    |
  1 | avoid = proc i -> {
    |                   ^
    |
    = hint: remove the braces, which are only for records: `x = i`
  
  1 error
  [1]
  $ cat > call.frob <<'FROB'
  > halve x = do { return x / 2 }
  > FROB
  $ frobc check call.frob
  error[E0110]: expected a statement, found `{`
   --> call.frob:1:14
    |
  1 | halve x = do { return x / 2 }
    |              ^
    |
    = hint: remove the braces, which are only for records: `return x / 2`
  
  1 error
  [1]
  $ cat > lambda.frob <<'FROB'
  > go :: SF Bool Float
  > go = switch (constant 1 &&& edge) \_ -> constant 2
  > 
  > far = map \case Just d -> d; Nothing -> 0
  > 
  > near = \ case Just d -> d
  > 
  > second (, x) = x
  > FROB
  $ frobc check lambda.frob
  error[E0110]: expected an operator, an argument, or the end of the expression, found `\`
   --> lambda.frob:2:35
    |
  2 | go = switch (constant 1 &&& edge) \_ -> constant 2
    |                                   ^
    |
    = hint: put the lambda in parentheses: `f (\x -> …)`
  
  error[E0110]: expected an operator, an argument, or the end of the expression, found `\case`
   --> lambda.frob:4:11
    |
  4 | far = map \case Just d -> d; Nothing -> 0
    |           ^^^^^
    |
    = hint: put the lambda in parentheses: `f (\x -> …)`
  
  error[E0110]: expected a parameter after `\`, found `case`
   --> lambda.frob:6:10
    |
  6 | near = \ case Just d -> d
    |          ^^^^
    |
    = hint: write, for example, `\x -> x + 1`; write `\case` without a space
  
  error[E0114]: a tuple with missing elements cannot be part of a pattern
   --> lambda.frob:8:8
    |
  8 | second (, x) = x
    |        ^^^^^
  
  4 errors
  [1]
  $ cat > cases.frob <<'FROB'
  > near :: Maybe Float -> Float
  > near = \case Just d -> d
  > far = \case
  > FROB
  $ frobc check cases.frob
  error[E0350]: this `case` does not cover every value
   --> cases.frob:2:8
    |
  2 | near = \case Just d -> d
    |        ^^^^^ there is no branch for `Nothing`
    |
    = hint: add a branch `Nothing -> …`
  
  error[E0350]: this `case` does not cover every value
   --> cases.frob:3:7
    |
  3 | far = \case
    |       ^^^^^ there is no branch for `_`
    |
    = hint: add a branch `_ -> …`
  
  2 errors
  [1]
  $ cat > unit.frob <<'FROB'
  > bell :: SF () (Event ())
  > bell = after 3 [s]
  > FROB
  $ frobc check unit.frob
  error[E0205]: there is a space between this unit and its number
   --> unit.frob:2:16
    |
  2 | bell = after 3 [s]
    |                ^^^
    |
    = hint: write the unit in square brackets directly after the number: `3[s]`
  
  1 error
  [1]

A switch whose signal function has no event, an Int with a decimal point, arithmetic on vectors, map
instead of mapSF, a name that several modules have:

  $ cat > types.frob <<'FROB'
  > import Geometry
  > 
  > follow, search :: SF Float Float
  > follow = identity
  > search = constant 0
  > 
  > robot :: SF Float Float
  > robot = switch follow (\_ -> search)
  > 
  > times :: Int -> Float -> Float
  > times n x = toFloat n * x
  > 
  > twice :: Float -> Float
  > twice x = times 2.0 x
  > 
  > way :: Point2 -> Point2 -> Point2
  > way a b = b - a
  > 
  > ages :: SF (Array 3 (Event Float)) (Array 3 Float)
  > ages = proc es -> map (hold 0) es
  > FROB
  $ frobc check types.frob
  error[E0301]: expected `SF Float (a, Event b)`, found `SF Float Float`
   --> types.frob:8:16
    |
  8 | robot = switch follow (\_ -> search)
    |         ------ ^^^^^^
    |         |
    |         argument 1 of `switch` is `SF Float (a, Event b)`
    |
    = hint: return the output and the event that ends the mode: `(follow &&& after 1[s])` ends it after 1 s; to end it when a condition `c` becomes True, return a pair, `(…, edge c)`
  
  error[E0312]: expected `Int`, found `Float`
    --> types.frob:14:17
     |
  14 | twice x = times 2.0 x
     |           ----- ^^^
     |           |
     |           argument 1 of `times` is `Int`
     |
     = hint: write a whole number without a decimal point: `2`
  
  error[E0301]: expected a number, found `Point2`
    --> types.frob:17:11
     |
  17 | way a b = b - a
     |           ^ - argument 1 of `-` is a number
     |
     = hint: for vectors, use `^-^`
  
  error[E0304]: expected a function, found a signal function: `SF (Event n[u]) n[u]`
    --> types.frob:20:24
     |
  20 | ages = proc es -> map (hold 0) es
     |                   ---  ^^^^^^
     |                   |
     |                   argument 1 of `map` is `a -> b`
     |
     = hint: use `mapSF` to run a signal function on each element
  
  4 errors
  [1]
  $ echo 'stop = constant resting' > resting.frob
  $ frobc check resting.frob
  error[E0205]: unknown name `resting`
   --> resting.frob:1:17
    |
  1 | stop = constant resting
    |                 ^^^^^^^
    |
    = hint: `resting` is in the library: `import Create` or `import Pioneer` or `import Ros` or `import Scout`
  
  1 error
  [1]

A class or instance without its `where`, a `do` as an argument:

  $ cat > instance.frob <<'FROB'
  > class Sized a where
  >     size :: a -> Float
  > 
  > instance Sized Bool
  >     size b = 1
  > 
  > dance :: Task () Float ()
  > dance = forever do
  >     sleepT 1[s] 0
  > FROB
  $ frobc check instance.frob
  error[E0110]: expected `where` or the end of the declaration, found `=`
   --> instance.frob:5:12
    |
  5 |     size b = 1
    |            ^
    |
    = hint: add `where`, and write the methods below it: `instance Sized Bool where`
  
  error[E0110]: expected an operator, an argument, or the end of the expression, found `do`
   --> instance.frob:8:17
    |
  8 | dance = forever do
    |                 ^^
    |
    = hint: put the `do` in parentheses, or write `$` before it
  
  2 errors
  [1]
