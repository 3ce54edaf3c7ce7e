Arguments of the wrong form: a negative number, a tuple of a different size, a
value for a signal function.

  $ cat > negative.frob <<'FROB'
  > f :: Float -> Float
  > f x = abs -1
  > 
  > g :: Float -> Float
  > g x = max x -1
  > FROB
  $ frobc check negative.frob
  error[E0301]: this `-` subtracts from a function
   --> negative.frob:2:11
    |
  2 | f x = abs -1
    |       --- ^
    |       |
    |       this is `n[u] -> n[u]`
    |
    = hint: put the negative argument in parentheses: `abs (-1)`
  
  error[E0301]: this `-` subtracts from a function
   --> negative.frob:5:13
    |
  5 | g x = max x -1
    |       ----- ^
    |       |
    |       this is `Float -> Float`
    |
    = hint: put the negative argument in parentheses: `max x (-1)`
  
  2 errors
  [1]

A minus with spaces on both sides, or on neither, is a subtraction.

  $ cat > minus.frob <<'FROB'
  > f :: Float -> Float
  > f x = x -1
  > 
  > g = abs - 1
  > FROB
  $ frobc check minus.frob
  error[E0301]: expected a number, found the function `n[u] -> n[u]`
   --> minus.frob:4:5
    |
  4 | g = abs - 1
    |     ^^^ - argument 1 of `-` is a number
    |
    = hint: `abs` takes 1 argument
  
  1 error
  [1]

  $ cat > tuple.frob <<'FROB'
  > f :: (Float, Float) -> Float
  > f (a, b) = a + b
  > 
  > x = f (1, 2, 3)
  > 
  > pair :: SF Float (Float, Float)
  > pair = proc x -> (x, x)
  > 
  > main :: SF Float Float
  > main = proc x -> a where
  >     (a, b, c) = pair x
  > FROB
  $ frobc check tuple.frob
  error[E0301]: expected a tuple with 2 elements, found one with 3
   --> tuple.frob:4:7
    |
  4 | x = f (1, 2, 3)
    |     - ^^^^^^^^^
    |     |
    |     argument 1 of `f` is `(Float, Float)`
    |
    = hint: a number is one too many
  
  error[E0301]: expected a tuple with 3 elements, found one with 2
    --> tuple.frob:11:17
     |
  11 |     (a, b, c) = pair x
     |     ---------   ^^^^^^ this is `(Float, Float)`
     |     |
     |     the pattern matches `(a, b, c)`
     |
     = hint: write the pattern as `(a, b)`
  
  2 errors
  [1]

  $ cat > value.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (roMake (setVelTR 0.3[m/s] 0))
  > FROB
  $ frobc check value.frob
  error[E0360]: a signal function is needed here, but `roMake` returns an output
   --> value.frob:2:25
    |
  2 | main = reactimateRobot (roMake (setVelTR 0.3[m/s] 0))
    |                         ^^^^^^
    |
    = hint: for a signal function that always returns this output, write `constant (roMake (setVelTR 0.3[m/s] 0))`
  
  1 error
  [1]

A function passed as an argument lacks one of its own arguments.

  $ cat > lacking.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.3[m/s]))
  > FROB
  $ frobc check lacking.frob
  error[E0301]: expected a function that takes one argument, found one that takes 2: `AngularVelocity -> a -> a`
   --> lacking.frob:2:43
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR 0.3[m/s]))
    |                                   ------  ^^^^^^^^^^^^^^^^^
    |                                   |
    |                                   argument 1 of `roMake` is `AngularVelocity -> AngularVelocity`
    |
    = hint: `setVelTR` lacks its second argument, `AngularVelocity` (1/s): write `setVelTR 0.3[m/s] 0`, for example
  
  1 error
  [1]
