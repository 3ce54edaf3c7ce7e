Missing, additional, or wrong arguments: the message shows the signature of the function.

  $ cat > distance_one_arg.frob <<'FROB'
  > import Robot
  > import Geometry
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = if distance (place i) > 1[m] then 0 else 0.2[m/s])
  > FROB
  $ frobc check distance_one_arg.frob
  error[E0301]: `distance` lacks an argument
   --> distance_one_arg.frob:4:12
    |
  4 |     v = if distance (place i) > 1[m] then 0 else 0.2[m/s])
    |            ^^^^^^^^^^^^^^^^^^   ---- but this is a number
    |
    = hint: add the last argument: `distance :: Vec2[u] -> Vec2[u] -> Float[u]`
  
  1 error
  [1]

  $ cat > lowpass_no_time.frob <<'FROB'
  > import Robot
  > import Control
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     d = lowPass (frontSonar i)
  >     v = 0.5[1/s] * d)
  > FROB
  $ frobc check lowpass_no_time.frob
  error[E0301]: `lowPass` lacks an argument before `(frontSonar i)`
   --> lowpass_no_time.frob:4:18
    |
  4 |     d = lowPass (frontSonar i)
    |         -------  ^^^^^^^^^^^^
    |         |
    |         `lowPass :: Time -> SF Float[u] Float[u]`
    |
    = hint: write `lowPass 1[s] (frontSonar i)`, with the value that you want in place of `1[s]`
  
  1 error
  [1]

  $ cat > foldl_two.frob <<'FROB'
  > main :: SF (Array 3 Float) Float
  > main = proc a -> foldl (+) a
  > FROB
  $ frobc check foldl_two.frob
  error[E0301]: `foldl` lacks an argument before `a`
   --> foldl_two.frob:2:28
    |
  2 | main = proc a -> foldl (+) a
    |                  -----     ^
    |                  |
    |                  `foldl :: (b -> a -> b) -> b -> Array n a -> b`
    |
    = hint: write `foldl (+) 0 a`, with the value that you want in place of `0`
  
  1 error
  [1]

  $ cat > max_array.frob <<'FROB'
  > main :: SF (Array 3 Float) Float
  > main = proc a -> max a
  > FROB
  $ frobc check max_array.frob
  error[E0301]: expected `Float`, found the function `Array 3 Float -> Array 3 Float`
   --> max_array.frob:2:18
    |
  1 | main :: SF (Array 3 Float) Float
    |         ------------------------ the signature of `main` requires the output `Float`
  2 | main = proc a -> max a
    |                  ^^^^^
    |
    = hint: `max` takes two values; for all elements, write `maximumBy id a`
  
  1 error
  [1]

  $ cat > generate_size.frob <<'FROB'
  > xs :: Array 5 Float
  > xs = generate 5 (\i -> toFloat i)
  > main = proc x -> x * xs ! 0
  > FROB
  $ frobc check generate_size.frob
  error[E0301]: expected `Int -> a`, found a number
   --> generate_size.frob:2:15
    |
  2 | xs = generate 5 (\i -> toFloat i)
    |      -------- ^
    |      |
    |      argument 1 of `generate` is `Int -> a`
    |
    = hint: `generate` takes one argument, but is applied to 2: `generate :: (Int -> a) -> Array n a`
  
  1 error
  [1]

  $ cat > array_float_index.frob <<'FROB'
  > main :: SF (Array 3 Float) Float
  > main = proc a -> a ! 1.0
  > FROB
  $ frobc check array_float_index.frob
  error[E0312]: expected `Int`, found `Float`
   --> array_float_index.frob:2:22
    |
  2 | main = proc a -> a ! 1.0
    |                  -   ^^^
    |                  |
    |                  this is `Array 3 Float`
    |
    = hint: write a whole number without a decimal point: `1`
  
  1 error
  [1]

  $ cat > at_order.frob <<'FROB'
  > main :: SF (Array 3 Float, Int) Float
  > main = proc (a, k) -> at a k 0
  > FROB
  $ frobc check at_order.frob
  error[E0301]: the arguments of `at` are in the wrong order
   --> at_order.frob:2:23
    |
  2 | main = proc (a, k) -> at a k 0
    |                       ^^^^^^^^
    |
    = hint: write `at k 0 a`
  
  1 error
  [1]

  $ cat > unit_convert.frob <<'FROB'
  > import Robot
  > toCm :: Distance -> Float
  > toCm d = d * 100
  > main = proc i -> toCm (frontSonar i)
  > FROB
  $ frobc check unit_convert.frob
  error[E0320]: expected no unit, found `m`
   --> unit_convert.frob:3:10
    |
  2 | toCm :: Distance -> Float
    |         ----------------- the signature of `toCm` requires `Float`
  3 | toCm d = d * 100
    |          ^^^^^^^ this is `Float[m]`
    |
    = hint: to get a plain number, divide by the unit: `(d * 100) / 1[m]`
    = hint: if this is the right result, write the signature as `toCm :: Distance -> Float[m]`
  
  1 error
  [1]

  $ cat > trial_seed_number.frob <<'FROB'
  > import Robot
  > import Trial
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 0))
  > trial "far" = Trial { world = "room.toml", lasts = 10[s], seeds = 5, judge = comesFar 1[m] 10[s] }
  > FROB
  $ frobc check trial_seed_number.frob
  error[E0301]: expected `Seeds`, found a number
   --> trial_seed_number.frob:4:67
    |
  4 | trial "far" = Trial { world = "room.toml", lasts = 10[s], seeds = 5, judge = comesFar 1[m] 10[s] }
    |                                                           -----   ^
    |                                                           |
    |                                                           the field `seeds` is `Seeds`
    |
    = hint: write the first and the last seed: ``1 `to` 5``
  
  1 error
  [1]
