Loops, calls, declarations and operators in the syntax of other languages: one
message for each.

C and Arduino:

  $ cat > if_without_then.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = if (frontSonar i > 0.5[m]) 0.3[m/s] else 0)
  > FROB
  $ frobc check if_without_then.frob
  error[E0110]: expected `then` after the condition, found `else`
   --> if_without_then.frob:4:45
    |
  4 |     v = if (frontSonar i > 0.5[m]) 0.3[m/s] else 0)
    |                                             ^^^^
    |
    = hint: put `then` after the condition: `if frontSonar i > 0.5[m] then 0.3[m/s] else 0`
  
  1 error
  [1]
  $ cat > arduino_loop.frob <<'FROB'
  > void loop() {
  >     setVelTR(0.2, 0);
  >     delay(1000);
  > }
  > FROB
  $ frobc check arduino_loop.frob
  error[E0110]: Frob has no `void`
   --> arduino_loop.frob:1:1
    |
  1 | void loop() {
    | ^^^^
    |
    = hint: Frob has no procedures: write equations that hold at every instant, as in `main = reactimateRobot (proc i -> roMake (setVelTR v omega))`
  
  1 error
  [1]
  $ cat > while_loop.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (do
  >     while (not (bumped i))
  >         sleepT 1[s] (roMake (setVelTR 0.2[m/s] 0)))
  > FROB
  $ frobc check while_loop.frob
  error[E0205]: unknown name `while`
   --> while_loop.frob:4:5
    |
  4 |     while (not (bumped i))
    |     ^^^^^
    |
    = hint: to repeat the tasks below, replace this line with `forever $ do`, or with `whileT (proc i -> …) $ do` to repeat them while a condition holds; to end a task when something happens, use `abortWhen`
  
  1 error
  [1]
  $ cat > int_declaration.frob <<'FROB'
  > main :: SF Int Int
  > main = proc n -> m where
  >     int m = n + 1
  > FROB
  $ frobc check int_declaration.frob
  error[E0205]: unknown name `m`
   --> int_declaration.frob:2:18
    |
  2 | main = proc n -> m where
    |                  ^
  3 |     int m = n + 1
    |     --- this defines a function `int`
    |
    = hint: write `m = n + 1`, without a type
  
  1 error
  [1]
  $ cat > define.frob <<'FROB'
  > #define V_MAX 0.4
  > 
  > main :: SF Float Float
  > main = proc x -> min x V_MAX
  > FROB
  $ frobc check define.frob
  error[E0103]: unexpected character `#`
   --> define.frob:1:1
    |
  1 | #define V_MAX 0.4
    | ^
    |
    = hint: define a constant by an equation: `v_max = 0.4`
  
  1 error
  [1]

Python:

  $ cat > print_call.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = 0.2[m/s]
  >     print("speed", v))
  > FROB
  $ frobc check print_call.frob
  error[E0110]: Frob has no `print`
   --> print_call.frob:5:5
    |
  5 |     print("speed", v))
    |     ^^^^^
    |
    = hint: a program cannot print, so remove this line: `frobc run` prints the result of a task when the task ends; to see other values, make them outputs, and write all outputs to a file with `--record`
  
  1 error
  [1]
  $ cat > colon_block.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     if bumped i:
  >         v = 0
  >     else:
  >         v = 0.3[m/s])
  > FROB
  $ frobc check colon_block.frob
  error[E0103]: unexpected character `:`
   --> colon_block.frob:4:16
    |
  4 |     if bumped i:
    |                ^
    |
    = hint: remove the colon: a block is delimited by its indentation; write a choice as `if c then a else b`
  
  1 error
  [1]
  $ cat > for_loop.frob <<'FROB'
  > main :: SF (Array 8 Distance) Distance
  > main = proc ds -> total where
  >     total = 0
  >     for d in ds:
  >         total = total + d
  > FROB
  $ frobc check for_loop.frob
  error[E0103]: unexpected character `:`
   --> for_loop.frob:4:16
    |
  4 |     for d in ds:
    |                ^
    |
    = hint: Frob has no loops: write `map f ds` or `foldl (+) 0 ds` for an array, or `forEachT ds f` to run a task for each element
  
  1 error
  [1]

MATLAB:

  $ cat > matlab_function.frob <<'FROB'
  > function y = twice(x)
  >     y = 2 * x;
  > end
  > 
  > main = arr twice
  > FROB
  $ frobc check matlab_function.frob
  error[E0110]: Frob has no `function`
   --> matlab_function.frob:1:1
    |
  1 | function y = twice(x)
    | ^^^^^^^^
    |
    = hint: define a function by an equation: `twice x = 2 * x`; a block ends where its indentation ends
  
  1 error
  [1]
  $ cat > element_powers.frob <<'FROB'
  > main :: SF (Array 3 Float) (Array 3 Float)
  > main = proc xs -> xs .^ 2
  > FROB
  $ frobc check element_powers.frob
  error[E0110]: Frob has no `.^`
   --> element_powers.frob:2:22
    |
  2 | main = proc xs -> xs .^ 2
    |                      ^^
    |
    = hint: operators take numbers, not arrays: write `xs ^ 2` for numbers, or `map (\x -> x ^ 2) xs` for arrays
  
  1 error
  [1]
  $ cat > tilde_equals.frob <<'FROB'
  > main :: SF (Int, Int) Bool
  > main = proc (a, b) -> a ~= b
  > FROB
  $ frobc check tilde_equals.frob
  error[E0103]: unexpected character `~`
   --> tilde_equals.frob:2:25
    |
  2 | main = proc (a, b) -> a ~= b
    |                         ^
    |
    = hint: use `/=` to compare for inequality
  
  1 error
  [1]

Haskell:

  $ cat > operator_definition.frob <<'FROB'
  > (|+|) :: Float -> Float -> Float
  > a |+| b = sqrt (a * a + b * b)
  > 
  > main :: SF (Float, Float) Float
  > main = proc (a, b) -> a |+| b
  > FROB
  $ frobc check operator_definition.frob
  error[E0110]: Frob has no `|+|`
   --> operator_definition.frob:1:2
    |
  1 | (|+|) :: Float -> Float -> Float
    |  ^^^
    |
    = hint: programs cannot define operators: define a function, such as `combine a b = sqrt (a * a + b * b)`, and write ``a `combine` b``
  
  1 error
  [1]
  $ cat > fmap_operator.frob <<'FROB'
  > main :: SF (Event Float) (Event Float)
  > main = proc e -> (* 2) <$> e
  > FROB
  $ frobc check fmap_operator.frob
  error[E0110]: Frob has no `<$>`
   --> fmap_operator.frob:2:24
    |
  2 | main = proc e -> (* 2) <$> e
    |                        ^^^
    |
    = hint: write `mapE (* 2) e` for an event, or `map (* 2) e` for an array
  
  1 error
  [1]
  $ cat > pure_result.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (do
  >     sleepT 1[s] (roMake (setVelTR 0.2[m/s] 0))
  >     pure ())
  > FROB
  $ frobc check pure_result.frob
  error[E0205]: unknown name `pure`
   --> pure_result.frob:5:5
    |
  5 |     pure ())
    |     ^^^^
    |
    = hint: write `return`
  
  1 error
  [1]
  $ cat > num_constraint.frob <<'FROB'
  > twice :: Num a => a -> a
  > twice x = x + x
  > 
  > main :: SF Float Float
  > main = arr twice
  > FROB
  $ frobc check num_constraint.frob
  error[E0223]: unknown type class `Num`
   --> num_constraint.frob:1:10
    |
  1 | twice :: Num a => a -> a
    |          ^^^
    |
    = hint: Frob has no numeric type classes: write `twice :: n[u] -> n[u]`
  
  1 error
  [1]

Units and numbers in other notations, tables with semicolons, `else` as a guard, a colon after a
condition.

  $ cat > writings.frob <<'EOF'
  > main :: SF Float Float
  > main = proc x -> if x > 1: 2 else 3
  > EOF
  $ frobc check writings.frob
  error[E0103]: unexpected character `:`
   --> writings.frob:2:26
    |
  2 | main = proc x -> if x > 1: 2 else 3
    |                          ^
    |
    = hint: use `if x > 1 then 2 else 3`
  
  1 error
  [1]
  $ cat > writings.frob <<'EOF'
  > v = 2[kmh]
  > w = 20[dps]
  > EOF
  $ frobc check writings.frob
  error[E0208]: unknown unit `kmh`
   --> writings.frob:1:7
    |
  1 | v = 2[kmh]
    |       ^^^
    |
    = hint: did you mean `km/hour`?
  
  error[E0208]: unknown unit `dps`
   --> writings.frob:2:8
    |
  2 | w = 20[dps]
    |        ^^^
    |
    = hint: did you mean `deg/s`?
  
  2 errors
  [1]
  $ printf 'half = 0.5f\n' > writings.frob
  $ frobc check writings.frob
  error[E0105]: the number `0.5` is directly followed by `f`
   --> writings.frob:1:8
    |
  1 | half = 0.5f
    |        ^^^^
    |
    = hint: remove the suffix: `0.5`
  
  1 error
  [1]
  $ printf 'table = [1, 2; 3, 4]\n' > writings.frob
  $ frobc check writings.frob
  error[E0111]: array elements are not separated by `;`
   --> writings.frob:1:14
    |
  1 | table = [1, 2; 3, 4]
    |              ^
    |
    = hint: the rows of a matrix are arrays: write `[[1, 2], [3, 4]]`
  
  1 error
  [1]
  $ cat > writings.frob <<'EOF'
  > sign :: Float -> Float
  > sign x
  >     | x < 0 = -1
  >     | else = 1
  > EOF
  $ frobc check writings.frob
  error[E0110]: expected the condition of a guard after `|`, found `else`
   --> writings.frob:4:7
    |
  4 |     | else = 1
    |       ^^^^
    |
    = hint: write the last guard as `| otherwise`
  
  1 error
  [1]
