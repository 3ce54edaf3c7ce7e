Python's constructs, and their equivalents in Frob.

  $ cat > definition.frob <<'FROB'
  > def twice(x):
  >     return x * 2
  > FROB
  $ frobc check definition.frob
  error[E0103]: unexpected character `:`
   --> definition.frob:1:13
    |
  1 | def twice(x):
    |             ^
    |
    = hint: define a function by an equation: `twice x = x * 2`
  
  1 error
  [1]

  $ cat > lambda.frob <<'FROB'
  > main :: SF Float Float
  > main = arr (lambda x: x + 1)
  > FROB
  $ frobc check lambda.frob
  error[E0103]: unexpected character `:`
   --> lambda.frob:2:21
    |
  2 | main = arr (lambda x: x + 1)
    |                     ^
    |
    = hint: write an anonymous function as `\x -> x + 1`
  
  1 error
  [1]

  $ cat > choice.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> y where
  >     y = x ** 2 if x > 0 else 0
  > FROB
  $ frobc check choice.frob
  error[E0110]: expected an operator, an argument, or the end of the expression, found `if`
   --> choice.frob:3:16
    |
  3 |     y = x ** 2 if x > 0 else 0
    |                ^^
    |
    = hint: use `if x > 0 then x ** 2 else 0`
  
  1 error
  [1]

  $ cat > block.frob <<'FROB'
  > f :: Float -> Float
  > f x = if x > 0:
  >     1
  > FROB
  $ frobc check block.frob
  error[E0103]: unexpected character `:`
   --> block.frob:2:15
    |
  2 | f x = if x > 0:
    |               ^
    |
    = hint: remove the colon: a block is delimited by its indentation; write a choice as `if c then a else b`
  
  1 error
  [1]

  $ cat > import.frob <<'FROB'
  > from Control import limit
  > main = arr (limit 1.0)
  > FROB
  $ frobc check import.frob
  error[E0110]: Frob has no `from`
   --> import.frob:1:1
    |
  1 | from Control import limit
    | ^^^^
    |
    = hint: use `import Control (limit)`
  
  1 error
  [1]

  $ cat > division.frob <<'FROB'
  > half :: Int -> Int
  > half n = n // 2
  > FROB
  $ frobc check division.frob
  error[E0110]: Frob has no `//`
   --> division.frob:2:12
    |
  2 | half n = n // 2
    |            ^^
    |
    = hint: use `--` to start a comment; to divide whole numbers, use `div`
  
  1 error
  [1]

