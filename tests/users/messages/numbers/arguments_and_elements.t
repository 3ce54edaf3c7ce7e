Arguments and elements: too few, too many, or without separators.

Arguments:

  $ cat > hysteresis_one_argument.frob <<'FROB'
  > import Control
  > 
  > main :: SF Float Bool
  > main = proc x -> hysteresis 1 x
  > FROB
  $ frobc check hysteresis_one_argument.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> hysteresis_one_argument.frob:4:18
    |
  3 | main :: SF Float Bool
    |         ------------- the signature of `main` requires the output `Bool`
  4 | main = proc x -> hysteresis 1 x
    |                  ^^^^^^^^^^^^^^ this is `SF Float Bool`
    |
    = note: expected `Bool`
    = hint: `hysteresis` takes two arguments before its signal: write `hysteresis 1 … x`, where the signal is `x`
  
  1 error
  [1]
  $ cat > delay_without_start.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> x - delay x
  > FROB
  $ frobc check delay_without_start.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> delay_without_start.frob:2:22
    |
  2 | main = proc x -> x - delay x
    |                  -   ^^^^^^^ this is `SF Float Float`
    |                  |
    |                  this is `Float`
    |
    = note: expected `Float`
    = hint: `delay` takes an initial value before its signal: write `delay 0 x`
  
  1 error
  [1]
  $ cat > argument_forgotten.frob <<'FROB'
  > import Control
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = limit (0.5[1/s] * frontSonar i))
  > FROB
  $ frobc check argument_forgotten.frob
  error[E0301]: expected `Velocity` (m/s), found the function `Float[m/s] -> Float[m/s]`
   --> argument_forgotten.frob:4:52
    |
  4 | main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
    |                                           -------- ^
    |                                           |
    |                                           argument 1 of `setVelTR` is `Velocity` (m/s)
  5 |     v = limit (0.5[1/s] * frontSonar i))
    |         ------------------------------- this is `v`; it lacks one argument
    |
    = hint: `limit` takes two arguments: `limit :: n[u] -> n[u] -> n[u]`
  
  1 error
  [1]
  $ cat > argument_too_many.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.3[m/s] 0 0))
  > FROB
  $ frobc check argument_too_many.frob
  error[E0301]: expected `a -> a`, found a number
   --> argument_too_many.frob:3:43
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR 0.3[m/s] 0 0))
    |                                   ------  ^^^^^^^^^^^^^^^^^^^^^
    |                                   |
    |                                   argument 1 of `roMake` is `a -> a`
    |
    = hint: `setVelTR` has one argument too many here: write `setVelTR 0.3[m/s] 0` for the function
  
  1 error
  [1]
  $ cat > negative_argument.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR -0.2[m/s] 0))
  > FROB
  $ frobc check negative_argument.frob
  error[E0301]: this `-` subtracts from a function
   --> negative_argument.frob:3:52
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR -0.2[m/s] 0))
    |                                           -------- ^
    |                                           |
    |                                           this is `Velocity -> AngularVelocity -> a -> a`
    |
    = hint: put the negative argument in parentheses: `setVelTR (-0.2[m/s])`
  
  1 error
  [1]
  $ cat > switch_to_signal_function.frob <<'FROB'
  > main :: SF Distance Velocity
  > main = switch (proc d -> (0.3[m/s], edge (d < 0.5[m]))) (constant 0)
  > FROB
  $ frobc check switch_to_signal_function.frob
  error[E0304]: expected a function, found a signal function: `SF a n[u]`
   --> switch_to_signal_function.frob:2:58
    |
  2 | main = switch (proc d -> (0.3[m/s], edge (d < 0.5[m]))) (constant 0)
    |        ------                                            ^^^^^^^^^^
    |        |
    |        argument 2 of `switch` is `() -> SF Float[m] Float[m/s]`
    |
    = hint: write a function that ignores its argument: `\_ -> constant 0`
  
  1 error
  [1]

Elements and fields:

  $ cat > array_without_commas.frob <<'FROB'
  > weights :: Array 3 Float
  > weights = [0.25 0.5 0.25]
  > 
  > main :: SF (Array 3 Float) (Array 3 Float)
  > main = proc xs -> zipWith (*) xs weights
  > FROB
  $ frobc check array_without_commas.frob
  error[E0302]: this is `Float`, not a function
   --> array_without_commas.frob:2:12
    |
  2 | weights = [0.25 0.5 0.25]
    |            ^^^^ --- it is applied to an argument here
    |
    = hint: put commas between the elements: `[0.25, 0.5, 0.25]`
  
  1 error
  [1]
  $ cat > index_in_parentheses.frob <<'FROB'
  > main :: SF (Array 3 Distance) Distance
  > main = proc ds -> ds(1) + ds(2)
  > FROB
  $ frobc check index_in_parentheses.frob
  error[E0302]: `ds` is `Array 3 Distance`, not a function
   --> index_in_parentheses.frob:2:19
    |
  2 | main = proc ds -> ds(1) + ds(2)
    |                   ^^ - it is applied to an argument here
    |
    = hint: write `ds ! 1` for that element; the first element is `! 0`
  
  error[E0302]: `ds` is `Array 3 Distance`, not a function
   --> index_in_parentheses.frob:2:27
    |
  2 | main = proc ds -> ds(1) + ds(2)
    |                           ^^ - it is applied to an argument here
    |
    = hint: write `ds ! 2` for that element; the first element is `! 0`
  
  2 errors
  [1]
  $ cat > fields_without_comma.frob <<'FROB'
  > data Gains = Gains { p :: Float, i :: Float }
  > 
  > main :: SF Float Gains
  > main = proc x -> Gains { p = x i = 2 }
  > FROB
  $ frobc check fields_without_comma.frob
  error[E0110]: expected an operator, `,` and another field, or `}`, found `=`
   --> fields_without_comma.frob:4:34
    |
  4 | main = proc x -> Gains { p = x i = 2 }
    |                                  ^
    |
    = hint: write a `,` between two fields
  
  1 error
  [1]
