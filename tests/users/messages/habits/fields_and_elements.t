Records and arrays in the syntax of other languages.

  $ cat > record_unknown_field.frob <<'FROB'
  > data St = St { x :: Float, y :: Float }
  > main = proc v -> St { x = v, z = 2, y = 1 }
  > FROB
  $ frobc check record_unknown_field.frob
  error[E0209]: constructor `St` has no field `z`
   --> record_unknown_field.frob:2:30
    |
  1 | data St = St { x :: Float, y :: Float }
    |           -- declared here
  2 | main = proc v -> St { x = v, z = 2, y = 1 }
    |                              ^
    |
    = note: its fields: `x`, `y`
  
  1 error
  [1]

  $ cat > record_function_access.frob <<'FROB'
  > data St = St { x :: Float, y :: Float }
  > main = proc s -> x s + y s
  > FROB
  $ frobc check record_function_access.frob
  error[E0205]: `x` is a field, not a function
   --> record_function_access.frob:2:18
    |
  2 | main = proc s -> x s + y s
    |                  ^
    |
    = hint: write `s.x`, or `\r -> r.x` if you need a function
  
  error[E0205]: `y` is a field, not a function
   --> record_function_access.frob:2:24
    |
  2 | main = proc s -> x s + y s
    |                        ^
    |
    = hint: write `s.y`, or `\r -> r.y` if you need a function
  
  2 errors
  [1]

  $ cat > record_update_call.frob <<'FROB'
  > data St = St { x :: Float, y :: Float }
  > main :: SF St St
  > main = proc s -> s.x(3)
  > FROB
  $ frobc check record_update_call.frob
  error[E0302]: this is `Float`, not a function
   --> record_update_call.frob:3:18
    |
  3 | main = proc s -> s.x(3)
    |                  ^^^ - it is applied to an argument here
    |
    = hint: for a copy of the record with a different `x`, write `s { x = 3 }`
  
  1 error
  [1]

  $ cat > enum_dot.frob <<'FROB'
  > data Mode = Drive | Turn
  > main = proc b -> if b then Mode.Drive else Mode.Turn
  > FROB
  $ frobc check enum_dot.frob
  error[E0215]: no module `Mode` is imported here
   --> enum_dot.frob:2:28
    |
  2 | main = proc b -> if b then Mode.Drive else Mode.Turn
    |                            ^^^^            ---- and here
    |
    = hint: `Mode` is a type, not a module, so it cannot qualify a constructor: remove `Mode.`
  
  1 error
  [1]

  $ cat > array_index_bracket.frob <<'FROB'
  > main :: SF (Array 4 Float) Float
  > main = proc a -> a[2]
  > FROB
  $ frobc check array_index_bracket.frob
  error[E0110]: a `[` directly after a name is neither an index nor an array
   --> array_index_bracket.frob:2:19
    |
  2 | main = proc a -> a[2]
    |                   ^
    |
    = hint: write `(a ! 2)` for an element of an array; to take a tuple apart, write an equation such as `(a, b) = a`; to pass an array as an argument, put a space before the `[`
  
  1 error
  [1]

  $ cat > array_type_c.frob <<'FROB'
  > main :: SF Float[4] Float
  > main = proc a -> sum a
  > FROB
  $ frobc check array_type_c.frob
  error[E0119]: the brackets after a type contain a unit, not the size of an array
   --> array_type_c.frob:1:18
    |
  1 | main :: SF Float[4] Float
    |                  ^
    |
    = hint: write `main :: SF (Array 4 Float) Float`
  
  1 error
  [1]

  $ cat > array_for.frob <<'FROB'
  > total :: Array 4 Float -> Float
  > total a = for x in a: s += x
  > main = proc a -> total a
  > FROB
  $ frobc check array_for.frob
  error[E0103]: unexpected character `:`
   --> array_for.frob:2:21
    |
  2 | total a = for x in a: s += x
    |                     ^
    |
    = hint: Frob has no `for`: write `foldl (+) 0 a` for the sum of an array, or `map f a` to compute a value for each element
  
  1 error
  [1]

  $ cat > array_len_mismatch.frob <<'FROB'
  > gains :: Array 3 Float
  > gains = [1, 2, 3, 4]
  > main = proc x -> x * gains ! 0
  > FROB
  $ frobc check array_len_mismatch.frob
  error[E0301]: expected `Array 3 Float`, found `Array 4 Float`
   --> array_len_mismatch.frob:2:9
    |
  1 | gains :: Array 3 Float
    |          ------------- the signature of `gains` requires `Array 3 Float`
  2 | gains = [1, 2, 3, 4]
    |         ^^^^^^^^^^^^
    |
    = hint: remove one element, or write `Array 4 Float` in the type
  
  1 error
  [1]

  $ cat > array_mixed.frob <<'FROB'
  > vals = [1, True, 3]
  > main = proc x -> x
  > FROB
  $ frobc check array_mixed.frob
  error[E0301]: expected a number, found `Bool`
   --> array_mixed.frob:1:12
    |
  1 | vals = [1, True, 3]
    |         -  ^^^^
    |         |
    |         the first element is a number
    |
    = hint: all elements of an array must have the same type: for values of several types, use a tuple, `(a, b)`, or a record
  
  1 error
  [1]

  $ cat > array_plus.frob <<'FROB'
  > main :: SF (Array 3 Float, Array 3 Float) (Array 3 Float)
  > main = proc (a, b) -> a + b
  > FROB
  $ frobc check array_plus.frob
  error[E0301]: expected a number, found `Array 3 Float`
   --> array_plus.frob:2:23
    |
  2 | main = proc (a, b) -> a + b
    |                       ^ - argument 1 of `+` is a number
    |
    = hint: to compute with the elements of two arrays, write `zipWith (+) a b`
  
  1 error
  [1]

  $ cat > array_slice.frob <<'FROB'
  > main :: SF (Array 4 Float) Float
  > main = proc a -> sum a[0:2]
  > FROB
  $ frobc check array_slice.frob
  error[E0103]: unexpected character `:`
   --> array_slice.frob:2:25
    |
  2 | main = proc a -> sum a[0:2]
    |                         ^
    |
    = hint: for part of an array, write `take xs` or `drop xs`; the type of the result determines its size
  
  1 error
  [1]

  $ cat > list_comp_if.frob <<'FROB'
  > main :: SF (Array 4 Float) (Array 4 Float)
  > main = proc a -> [x * 2 for x in a]
  > FROB
  $ frobc check list_comp_if.frob
  error[E0110]: Frob has no array comprehensions
   --> list_comp_if.frob:2:31
    |
  2 | main = proc a -> [x * 2 for x in a]
    |                               ^^
    |
    = hint: use `map (\x -> x * 2) a` to compute each element
  
  1 error
  [1]

  $ cat > field_of_a_field.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = if (robotPose i).x > 1[m] then 0 else 0.3[m/s])
  > FROB
  $ frobc check field_of_a_field.frob
  error[E0310]: `Pose` has no field `x`
   --> field_of_a_field.frob:3:26
    |
  3 |     v = if (robotPose i).x > 1[m] then 0 else 0.3[m/s])
    |             -----------  ^
    |             |
    |             this is `Pose`
    |
    = hint: its part `position` has this field: write `(robotPose i).position.x`
  
  1 error
  [1]

  $ cat > sqrt_dist.frob <<'FROB'
  > import Robot
  > import Geometry
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     d = sqrt (place i)
  >     v = if d > 1[m] then 0 else 0.2[m/s])
  > FROB
  $ frobc check sqrt_dist.frob
  error[E0301]: expected `Float[u]`, found `Point2`
   --> sqrt_dist.frob:4:15
    |
  4 |     d = sqrt (place i)
    |         ----  ^^^^^^^
    |         |
    |         argument 1 of `sqrt` is `Float[u]`
    |
    = hint: for a component of the vector, write `(place i).x`, `(place i).y`; for its length, write `norm (place i)`
  
  1 error
  [1]

  $ cat > heading_sub.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR 0 w) where
  >     w = 2[1/s] * (robotPose i - 90[deg]))
  > FROB
  $ frobc check heading_sub.frob
  error[E0301]: expected a number, found `Pose`
   --> heading_sub.frob:3:19
    |
  3 |     w = 2[1/s] * (robotPose i - 90[deg]))
    |                   ^^^^^^^^^^^ - argument 1 of `-` is a number
    |
    = hint: this is a record: choose one of its fields, `(robotPose i).position`, `(robotPose i).heading`
  
  1 error
  [1]

  $ cat > tuple_three_fst.frob <<'FROB'
  > main :: SF (Float, Float, Float) Float
  > main = proc p -> fst p
  > FROB
  $ frobc check tuple_three_fst.frob
  error[E0301]: expected a tuple with 2 elements, found one with 3
   --> tuple_three_fst.frob:2:22
    |
  2 | main = proc p -> fst p
    |                  --- ^ this is `(Float, Float, Float)`
    |                  |
    |                  argument 1 of `fst` is `(a, b)`
    |
    = hint: to get its elements, write an equation: `(a, b, c) = p`
  
  1 error
  [1]

  $ cat > tuple_return_list.frob <<'FROB'
  > f :: Float -> (Float, Float)
  > f x = [x, x]
  > main = proc x -> f x
  > FROB
  $ frobc check tuple_return_list.frob
  error[E0301]: expected `(Float, Float)`, found `Array 2 Float`
   --> tuple_return_list.frob:2:7
    |
  1 | f :: Float -> (Float, Float)
    |      ----------------------- the signature of `f` requires `(Float, Float)`
  2 | f x = [x, x]
    |       ^^^^^^
    |
    = hint: use parentheses for a tuple: `(x, x)`
  
  1 error
  [1]

  $ cat > array_2d.frob <<'FROB'
  > m :: Array 2 2 Float
  > m = [[1, 2], [3, 4]]
  > main = proc x -> x
  > FROB
  $ frobc check array_2d.frob
  error[E0216]: type `Array` takes 2 type arguments, not 3
   --> array_2d.frob:1:6
    |
  1 | m :: Array 2 2 Float
    |      ^^^^^^^^^^^^^^^
    |
    = hint: write a matrix as an array of arrays: `Array 2 (Array 3 Float)`
  
  1 error
  [1]

  $ cat > array_2d_index.frob <<'FROB'
  > m :: Array 2 (Array 2 Float)
  > m = [[1, 2], [3, 4]]
  > main = proc x -> x * m ! 0, 1
  > FROB
  $ frobc check array_2d_index.frob
  error[E0110]: expected an operator, an argument, or the end of this definition, found `,`
   --> array_2d_index.frob:3:27
    |
  3 | main = proc x -> x * m ! 0, 1
    |                           ^
    |
    = hint: write one `!` for each index: `m ! 0 ! 1`
  
  1 error
  [1]

  $ cat > string_format.frob <<'FROB'
  > import Robot
  > import Display
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 0 . draw (number ("front" + "sonar") (frontSonar i))))
  > FROB
  $ frobc check string_format.frob
  error[E0301]: expected a number, found `String`
   --> string_format.frob:3:79
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 0 . draw (number ("front" + "sonar") (frontSonar i))))
    |                                                                               ^^^^^^^ - argument 1 of `+` is a number
    |
    = hint: a string is only a label: you cannot compute with strings or concatenate them
  
  1 error
  [1]
