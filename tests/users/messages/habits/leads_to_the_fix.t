Mistakes of newcomers, each with the fix that its message leads to. Every replacement that a message
offers compiles when it is pasted.

An index in brackets after a call:

  $ cat > index.frob <<'FROB'
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     near = (sonars i)[3]
  >     v = if hold 2[m] near.echo < 1[m] then 0 else 0.3[m/s])
  > FROB
  $ frobc check index.frob
  error[E0302]: `sonars` takes 1 argument, but is given 2
   --> index.frob:4:22
    |
  4 |     near = (sonars i)[3]
    |             ------   ^^^ one too many
    |             |
    |             with one argument, its result is `Array 16 Sonar`
    |
    = hint: write `sonars i ! 3` for that element; the first element is `! 0`
  
  1 error
  [1]
  $ sed 's/(sonars i)\[3\]/sonars i ! 3/' index.frob > pasted.frob && frobc check pasted.frob

A call with parentheses and commas, of functions that also accept tuples:

  $ cat > tuple.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> max(x, 0)
  > FROB
  $ frobc check tuple.frob
  error[E0301]: `max` takes 2 arguments, but is given one tuple
   --> tuple.frob:2:18
    |
  1 | main :: SF Float Float
    |         -------------- the signature of `main` requires the output `Float`
  2 | main = proc x -> max(x, 0)
    |                  ^^^^^^^^^
    |
    = hint: write the arguments without parentheses or commas: `max x 0`
  
  1 error
  [1]
  $ sed 's/max(x, 0)/max x 0/' tuple.frob > pasted.frob && frobc check pasted.frob

  $ cat > tuple_named.frob <<'FROB'
  > main :: SF (Float, Float) Float
  > main = proc (a, b) -> y where
  >     y = min(a, b)
  > FROB
  $ frobc check tuple_named.frob
  error[E0301]: `min` takes 2 arguments, but is given one tuple
   --> tuple_named.frob:3:9
    |
  1 | main :: SF (Float, Float) Float
    |         ----------------------- the signature of `main` requires the output `Float`
  2 | main = proc (a, b) -> y where
  3 |     y = min(a, b)
    |         ^^^^^^^^^
    |
    = hint: write the arguments without parentheses or commas: `min a b`
  
  1 error
  [1]
  $ sed 's/min(a, b)/min a b/' tuple_named.frob > pasted.frob && frobc check pasted.frob

A C comment at the start of a line:

  $ cat > comment.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> y where
  >     z = x * 2
  >     // slow
  >     y = z / 2
  > FROB
  $ frobc check comment.frob
  error[E0110]: Frob has no `//`
   --> comment.frob:4:5
    |
  4 |     // slow
    |     ^^
    |
    = hint: write `--` to start a comment
  
  1 error
  [1]
  $ sed 's:// slow:-- slow:' comment.frob > pasted.frob && frobc check pasted.frob

The mathematics module of Python:

  $ cat > math.frob <<'FROB'
  > import math
  > main :: SF Float Float
  > main = proc x -> math.sin(x)
  > FROB
  $ frobc check math.frob
  error[E0110]: expected the name of a module, starting with a capital letter, found `math`
   --> math.frob:1:8
    |
  1 | import math
    |        ^^^^
    |
    = hint: remove the import: mathematical functions are built in, as in `sin x` and `sqrt x`
  
  1 error
  [1]
  $ sed '/import/d; s/math.sin(x)/sin x/' math.frob > pasted.frob && frobc check pasted.frob

A command in a branch of a `proc`:

  $ cat > branch.frob <<'FROB'
  > main :: SF Float Float[s]
  > main = proc v -> do
  >     if v > 0 then do
  >         x <- integral -< v
  >     returnA -< x
  > FROB
  $ frobc check branch.frob
  error[E0116]: a branch of a `proc` cannot contain commands
   --> branch.frob:4:14
    |
  3 |     if v > 0 then do
    |                   -- this `do` is in a branch
  4 |         x <- integral -< v
    |              ^^^^^^^^^^^^^
    |
    = hint: choose the input, and run the command at every instant: `x <- integral -< if v > 0 then v else 0`
    = hint: to restart the signal function whenever the condition becomes True: `x <- resetOn integral -< (v, edge (v > 0))`
  
  1 error
  [1]
  $ sed '/if v/d; s/ *x <- integral -< v/    x <- integral -< if v > 0 then v else 0/' branch.frob > pasted.frob && frobc check pasted.frob
  $ sed '/if v/d; s/ *x <- integral -< v/    x <- resetOn integral -< (v, edge (v > 0))/' branch.frob > pasted.frob && frobc check pasted.frob

Waiting among equations:

  $ cat > wait.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> y where
  >     y = x
  >     delay(1000)
  > FROB
  $ frobc check wait.frob
  error[E0110]: an equation cannot wait: it holds at every instant
   --> wait.frob:4:5
    |
  4 |     delay(1000)
    |     ^^^^^
    |
    = hint: to wait in a task, write `sleepT 1[s] restingOutput`; in a `proc`, `after 1[s] ()` is an event that occurs 1 s after the start
  
  1 error
  [1]
  $ sed 's/y = x/y = if isEvent late then x else 0/; s/delay(1000)/late = after 1[s] ()/' wait.frob > pasted.frob && frobc check pasted.frob

  $ cat > wait_in_do.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> do
  >     delay(1000)
  >     returnA -< x
  > FROB
  $ frobc check wait_in_do.frob
  error[E0116]: a `proc` cannot wait: all its statements hold at every instant
   --> wait_in_do.frob:3:5
    |
  3 |     delay(1000)
    |     ^^^^^
    |
    = hint: to wait in a task, write `sleepT 1[s] restingOutput`; in a `proc`, `after 1[s] ()` is an event that occurs 1 s after the start
  
  1 error
  [1]
  $ sed 's/delay(1000)/late <- after 1[s] -< ()/; s/-< x/-< if isEvent late then x else 0/' wait_in_do.frob > pasted.frob && frobc check pasted.frob

Patterns of lists:

  $ cat > list.frob <<'FROB'
  > total :: Array n Float -> Float
  > total xs = case xs of
  >     [] -> 0
  >     x:rest -> x + total rest
  > main :: SF (Array 3 Float) Float
  > main = arr total
  > FROB
  $ frobc check list.frob
  error[E0114]: no array matches `[]`, because every array has at least one element
   --> list.frob:3:5
    |
  3 |     [] -> 0
    |     ^^
    |
    = hint: to combine all elements, write `foldl (+) 0 xs` or `sum xs`; for a single element, write `xs ! 0`
  
  error[E0103]: unexpected character `:`
   --> list.frob:4:6
    |
  4 |     x:rest -> x + total rest
    |      ^
    |
    = hint: an array cannot be split into its first element and the rest; to combine all elements, write `foldl (+) 0 xs` or `sum xs`; for a single element, write `xs ! 0`
  
  2 errors
  [1]
  $ sed '/\[\]/d; /rest/d; s/case xs of/foldl (+) 0 xs/' list.frob > pasted.frob && frobc check pasted.frob
  $ sed '/\[\]/d; /rest/d; s/case xs of/sum xs/' list.frob > pasted.frob && frobc check pasted.frob

A `switch` of C on one line:

  $ cat > switch.frob <<'FROB'
  > data S = A | B
  > f :: S -> Int
  > f s = switch (s) { case A: 1; case B: 2; }
  > main :: SF S Int
  > main = arr f
  > FROB
  $ frobc check switch.frob
  error[E0103]: unexpected character `:`
   --> switch.frob:3:26
    |
  3 | f s = switch (s) { case A: 1; case B: 2; }
    |                          ^
    |
    = hint: to choose by value, write `case s of`, and below it one branch on each line, such as `1 -> x`, ending with `_ -> y`
  
  1 error
  [1]
  $ sed 's/switch.*/case s of\n    A -> 1\n    _ -> 2/' switch.frob > pasted.frob && frobc check pasted.frob

A function of arrays written like a method:

  $ cat > method.frob <<'FROB'
  > main :: SF (Array 3 Float) (Array 3 Float)
  > main = proc xs -> xs.map (\x -> x * 2)
  > FROB
  $ frobc check method.frob
  error[E0310]: `Array 3 Float` has no field `map`
   --> method.frob:2:22
    |
  2 | main = proc xs -> xs.map (\x -> x * 2)
    |                   -- ^^^
    |                   |
    |                   this is `Array 3 Float`
    |
    = hint: `map` is a function: write `map (\x -> x * 2) xs`
  
  1 error
  [1]
  $ sed 's/xs.map.*/map (\\x -> x * 2) xs/' method.frob > pasted.frob && frobc check pasted.frob

A condition as a test:

  $ cat > test.frob <<'FROB'
  > import Trial
  > main :: SF Float Float
  > main = proc x -> x
  > test "x" = 1 + 1 == 2
  > FROB
  $ frobc check test.frob
  $ sed 1d test.frob > pasted.frob && frobc test pasted.frob
  ok    x: 0.001 s
  1 test: all hold
  $ sed 's/== 2/== 3/' test.frob > pasted.frob && frobc test pasted.frob
  FAIL  x: failed at 0.000 s
        frobc view failed/x.csv pasted.frob --entry 'judge test x' --at 0s
  1 test: 1 failed
  [1]
  $ sed 's/= 1 + 1 == 2/= during 1[s] (proc () -> 1 + 1 == 2)/' test.frob > pasted.frob && frobc check pasted.frob

A test that is neither a condition nor a `Test`:

  $ sed 's/= 1 + 1 == 2/= 5/' test.frob > wrong.frob && frobc check wrong.frob
  error[E0301]: expected `Test`, found a number
   --> wrong.frob:4:12
    |
  4 | test "x" = 5
    |      ---   ^
    |      |
    |      the value after this name must be `Test`
    |
    = hint: write a condition, such as `f 2 == 5`, or `during 1[s] sf` for a signal function
  
  1 error
  [1]

A function of the robot's input among the statements of a task:

  $ cat > place.frob <<'FROB'
  > import Robot
  > act :: Task RobotInput RobotOutput Bool
  > act = do
  >     p <- place
  >     driveTo p
  > main :: Program RobotInput RobotOutput
  > main = reactimateTask act
  > FROB
  $ frobc check place.frob
  error[E0370]: each statement in a `do` must be a task, but this is a function
   --> place.frob:4:10
    |
  2 | act :: Task RobotInput RobotOutput Bool
    |        -------------------------------- each task of this `do` must be `Task RobotInput RobotOutput a`
  3 | act = do
  4 |     p <- place
    |          ^^^^^ this is `b -> Point2`
    |
    = hint: write `robotPlace`, a task that returns the robot's position
  
  1 error
  [1]
  $ sed 's/<- place/<- robotPlace/' place.frob > pasted.frob && frobc check pasted.frob

  $ cat > reading.frob <<'FROB'
  > import Robot
  > clear :: RobotInput -> Bool
  > clear i = (contacts i).front
  > act :: Task RobotInput RobotOutput Bool
  > act = do
  >     b <- clear
  >     return b
  > main :: Program RobotInput RobotOutput
  > main = reactimateTask act
  > FROB
  $ frobc check reading.frob
  error[E0370]: each statement in a `do` must be a task, but this is a function
   --> reading.frob:6:10
    |
  4 | act :: Task RobotInput RobotOutput Bool
    |        -------------------------------- each task of this `do` must be `Task RobotInput RobotOutput a`
  5 | act = do
  6 |     b <- clear
    |          ^^^^^ this is `RobotInput -> Bool`
    |
    = hint: to apply it to the input once, write `ask (arr clear)`
  
  1 error
  [1]
  $ sed 's/<- clear/<- ask (arr clear)/' reading.frob > pasted.frob && frobc check pasted.frob

A constant of C with a capital:

  $ cat > const.frob <<'FROB'
  > const float K = 3;
  > main :: SF Float Float
  > main = proc x -> K * x
  > FROB
  $ frobc check const.frob
  error[E0206]: unknown constructor `K`
   --> const.frob:1:13
    |
  1 | const float K = 3;
    | -----       ^
    | |
    | this defines a function `const`
  2 | main :: SF Float Float
  3 | main = proc x -> K * x
    |                  - and here
    |
    = hint: declare it as `k :: Float` and, on the next line, `k = 3`
  
  1 error
  [1]
  $ sed '1s/.*/k :: Float\nk = 3/; s/K \*/k */' const.frob > pasted.frob && frobc check pasted.frob

Functions of arrays that have another name in the library:

  $ cat > sort.frob <<'FROB'
  > main :: SF (Array 3 Float) Float
  > main = proc xs -> sorted xs ! 0
  > FROB
  $ frobc check sort.frob
  error[E0205]: unknown name `sorted`
   --> sort.frob:2:19
    |
  2 | main = proc xs -> sorted xs ! 0
    |                   ^^^^^^
    |
    = hint: write `sort xs`, with `import Arrays`
  
  1 error
  [1]
  $ sed 's/sorted xs/sort xs/; 1i import Arrays' sort.frob > pasted.frob && frobc check pasted.frob

  $ cat > median.frob <<'FROB'
  > main :: SF (Array 3 Float) Float
  > main = proc xs -> median xs
  > FROB
  $ frobc check median.frob
  error[E0205]: unknown name `median`
   --> median.frob:2:19
    |
  2 | main = proc xs -> median xs
    |                   ^^^^^^
    |
    = hint: `median` is in the library: `import Filters`
  
  1 error
  [1]
  $ sed '1i import Filters' median.frob > pasted.frob && frobc check pasted.frob

A signal as the initial value of `delay`:

  $ cat > initial.frob <<'FROB'
  > main :: SF Float Float
  > main = proc n -> n - delay n n
  > FROB
  $ frobc check initial.frob
  error[E0340]: the initial value of `delay` must be static, but `n` is a signal
   --> initial.frob:2:28
    |
  2 | main = proc n -> n - delay n n
    |             -              ^
    |             |
    |             `n` is a signal: it comes from the `proc`'s input here
    |
    = hint: write a constant, as in `delay 0 x`; to start with the first value of `x` instead, write `previous x`, with `import Control`
  
  1 error
  [1]
  $ sed 's/delay n n/delay 0 n/' initial.frob > pasted.frob && frobc check pasted.frob
  $ sed -e '1i import Control' -e 's/delay n n/previous n/' initial.frob > pasted.frob && frobc check pasted.frob

An argument that is an application without parentheses:

  $ cat > application.frob <<'FROB'
  > import Robot
  > speed :: Distance -> Velocity
  > speed d = if d < 1[m] then 0 else 0.3[m/s]
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (proc i -> roMake (setVelTR speed (frontSonar i) 0))
  > FROB
  $ frobc check application.frob
  error[E0301]: expected `Velocity` (m/s), found the function `Distance -> Velocity`
   --> application.frob:5:52
    |
  5 | main = reactimateRobot (proc i -> roMake (setVelTR speed (frontSonar i) 0))
    |                                           -------- ^^^^^
    |                                           |
    |                                           argument 1 of `setVelTR` is `Velocity` (m/s)
    |
    = hint: put parentheses around the argument: `setVelTR (speed (frontSonar i)) 0`
  
  1 error
  [1]
  $ sed 's/setVelTR speed (frontSonar i) 0/setVelTR (speed (frontSonar i)) 0/' application.frob > pasted.frob && frobc check pasted.frob

A command with the wrong unit:

  $ cat > command.frob <<'FROB'
  > main :: SF Distance Velocity
  > main = proc x -> do
  >     returnA -< x
  > FROB
  $ frobc check command.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> command.frob:3:5
    |
  1 | main :: SF Distance Velocity
    |         -------------------- the signature of `main` requires the output `Velocity` (m/s)
  2 | main = proc x -> do
  3 |     returnA -< x
    |     ^^^^^^^^^^^^ this is `Distance` (m)
    |
    = hint: multiply by a gain, as in `returnA -< 0.5[1/s] * x`, or, for the rate of change, write `returnA -< derivative x`
    = hint: if this is the right result, write the signature as `main :: SF Distance Distance`
  
  1 error
  [1]
  $ sed 's/returnA -< x/returnA -< 0.5[1\/s] * x/' command.frob > pasted.frob && frobc check pasted.frob
  $ sed 's/returnA -< x/returnA -< derivative x/' command.frob > pasted.frob && frobc check pasted.frob
  $ sed 's/Velocity/Float[m]/' command.frob > pasted.frob && frobc check pasted.frob

  $ cat > plain.frob <<'FROB'
  > main :: SF Distance Float
  > main = proc x -> do
  >     returnA -< x
  > FROB
  $ frobc check plain.frob
  error[E0320]: expected no unit, found `m`
   --> plain.frob:3:5
    |
  1 | main :: SF Distance Float
    |         ----------------- the signature of `main` requires the output `Float`
  2 | main = proc x -> do
  3 |     returnA -< x
    |     ^^^^^^^^^^^^ this is `Distance` (m)
    |
    = hint: to get a plain number, divide by the unit: `returnA -< x / 1[m]`
    = hint: if this is the right result, write the signature as `main :: SF Distance Distance`
  
  1 error
  [1]
  $ sed 's/returnA -< x/returnA -< x \/ 1[m]/' plain.frob > pasted.frob && frobc check pasted.frob

  $ cat > integrated.frob <<'FROB'
  > main :: SF Distance Float
  > main = proc x -> do
  >     integral -< x
  > FROB
  $ frobc check integrated.frob
  error[E0320]: expected no unit, found `m s`
   --> integrated.frob:3:5
    |
  1 | main :: SF Distance Float
    |         ----------------- the signature of `main` requires the output `Float`
  2 | main = proc x -> do
  3 |     integral -< x
    |     ^^^^^^^^^^^^^ this is `Float[m s]`
    |
    = hint: to get a plain number, divide by the unit: `y <- integral -< x`, then `returnA -< y / 1[m s]`
    = hint: if this is the right result, write the signature as `main :: SF Distance Float[m s]`
  
  1 error
  [1]
  $ sed 's/integral -< x/y <- integral -< x\n    returnA -< y \/ 1[m s]/' integrated.frob > pasted.frob && frobc check pasted.frob

A negative factor:

  $ cat > negative.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> x * -1
  > FROB
  $ frobc check negative.frob
  error[E0113]: a minus sign directly after `*` needs parentheses
   --> negative.frob:2:22
    |
  2 | main = proc x -> x * -1
    |                      ^
    |
    = hint: put it and its operand in parentheses: `x * (-1)`
  
  1 error
  [1]
  $ sed 's/x \* -1/x * (-1)/' negative.frob > pasted.frob && frobc check pasted.frob

A type without its unit:

  $ cat > vector.frob <<'FROB'
  > import Geometry
  > main :: SF Float Vec2
  > main = proc x -> Vec2 { x = x, y = 0 }
  > FROB
  $ frobc check vector.frob
  error[E0216]: type `Vec2` takes 1 unit argument, not 0
   --> vector.frob:2:18
    |
  2 | main :: SF Float Vec2
    |                  ^^^^
    |
   ::: stdlib/Geometry.frob:7:6
    |
  7 | data Vec2[u] = Vec2 { x :: Float[u], y :: Float[u] }
    |      ---- declared here
    |
    = hint: write `Vec2[1]` for plain numbers, or add the unit of the numbers, as in `Vec2[m]`
  
  1 error
  [1]
  $ sed 's/Float Vec2/Float Vec2[1]/' vector.frob > pasted.frob && frobc check pasted.frob
  $ sed 's/Float Vec2/Distance Vec2[m]/' vector.frob > pasted.frob && frobc check pasted.frob

A size in a pattern:

  $ cat > size.frob <<'FROB'
  > type N = 5
  > main :: SF Int Bool
  > main = proc k -> case k of
  >     N -> True
  >     _ -> k == N - 1
  > FROB
  $ frobc check size.frob
  error[E0206]: unknown constructor `N`
   --> size.frob:4:5
    |
  4 |     N -> True
    |     ^
    |
    = note: `N` is a size: use it in types and expressions, not in patterns
    = hint: write the number: `5`
  
  1 error
  [1]
  $ sed -e 's/N ->/5 ->/' size.frob > pasted.frob && frobc check pasted.frob

A plain number plus a distance:

  $ cat > operands.frob <<'FROB'
  > main :: SF Distance Float
  > main = proc x -> x / 1[km] + x
  > FROB
  $ frobc check operands.frob
  error[E0320]: the operands of `+` have different units: `1` and `m`
   --> operands.frob:2:30
    |
  2 | main = proc x -> x / 1[km] + x
    |                  ---------   ^ this is `Distance` (m)
    |                  |
    |                  this is `Float`
    |
    = hint: divide by the unit, `x / 1[m]`, or multiply the plain number by it: `(x / 1[km]) * 1[m]`
  
  1 error
  [1]
  $ sed 's/+ x/+ x \/ 1[m]/' operands.frob > pasted.frob && frobc check pasted.frob
  $ sed 's/x . 1.km. + x/(x \/ 1[km]) * 1[m] + x/; s/Distance Float/Distance Distance/' operands.frob > pasted.frob && frobc check pasted.frob

Equations of a `proc` without `where`:

  $ cat > where.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> y
  >     y = x * 2
  > FROB
  $ frobc check where.frob
  error[E0110]: expected an operator, an argument, or the end of this definition, found `=`
   --> where.frob:3:7
    |
  3 |     y = x * 2
    |       ^
    |
    = hint: this line is indented further than column 1, where the definitions of this block start, so it continues the line above; if it is an equation, add `where` to that line: `main = proc x -> y where`
  
  1 error
  [1]
  $ sed 's/-> y/-> y where/' where.frob > pasted.frob && frobc check pasted.frob

Two modes that may change endlessly within one instant:

  $ cat > modes.frob <<'FROB'
  > main :: SF Float Float
  > main = low
  > low :: SF Float Float
  > low = switch (proc x -> (0, when (x >= 3))) (\_ -> high)
  > high :: SF Float Float
  > high = switch (proc x -> (1, when (x <= 3))) (\_ -> low)
  > FROB
  $ frobc check modes.frob
  error[E0402]: `low → high → low` may repeat endlessly within one instant
   --> modes.frob:4:15
    |
  4 | low = switch (proc x -> (0, when (x >= 3))) (\_ -> high)
    |               ^^^^^^^^^^^^^^^^^^^^^^^^^^^^         ---- `low` may start `high` at its own first instant
    |                             |
    |                             `when` may occur at the first instant of `low`
  5 | high :: SF Float Float
  6 | high = switch (proc x -> (1, when (x <= 3))) (\_ -> low)
    |                              -------------          --- `high` may start `low` at its own first instant
    |                              |
    |                              `when` may occur at the first instant of `high`
    |
    = note: no time passes between these steps when each ends as soon as it starts
    = hint: apply `notYet` to the event to ignore it at the first instant; `edge` would wait forever if the condition were true from the start
  
  1 error
  [1]
  $ sed 's/when (x <= 3)/notYet (when (x <= 3))/' modes.frob > pasted.frob && frobc check pasted.frob
  $ sed 's/when (x/edge (x/' modes.frob > pasted.frob && frobc check pasted.frob

One name with two equations:

  $ cat > twice.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> v where
  >     v = x
  >     v = v + 1
  > FROB
  $ frobc check twice.frob
  error[E0212]: `v` is defined twice here
   --> twice.frob:4:5
    |
  3 |     v = x
    |     - first defined here
  4 |     v = v + 1
    |     ^
    |
    = hint: write one equation, `v = x + 1`, because an equation holds at every instant, unlike an assignment
  
  1 error
  [1]
  $ sed '/v = x/d; s/v + 1/delay 0 v + 1/' twice.frob > pasted.frob && frobc check pasted.frob
  warning[W0305]: `x` is never used
   --> pasted.frob:2:13
    |
  2 | main = proc x -> v where
    |             ^
    |
    = hint: replace it with `_` or `_x`
  
  1 warning

A command under its name in other tools:

  $ frobc fmt twice.frob
  frobc: unknown command 'fmt', did you mean 'format'?
  Usage: frobc COMMAND …
  Try 'frobc --help' for more information.
  [2]

A signal function in place of a program:

  $ cat > drive.frob << 'END'
  > import Robot
  > 
  > drive :: SF RobotInput RobotOutput
  > drive = proc _ -> roMake (setVelTR 0.2[m/s] 0)
  > 
  > main :: Program RobotInput RobotOutput
  > main = drive
  > END
  $ frobc check drive.frob 2>&1 | grep -e ^error -e hint
  error[E0301]: expected a program, found a signal function
    = hint: write `reactimateRobot drive`
  $ sed -i 's/^main = drive/main = reactimateRobot drive/' drive.frob && frobc check drive.frob

An array comprehension of Python, and a comment of MATLAB:

  $ printf 'main :: SF Float Float\nmain = proc x -> sum [y * x for y in [1, 2, 3]]\n' > of.frob
  $ frobc check of.frob 2>&1 | grep hint
    = hint: use `map (\y -> y * x) [1, 2, 3]` to compute each element
  $ printf '%% doubles\nmain :: SF Float Float\nmain = proc x -> 2 * x\n' > comment.frob
  $ frobc check comment.frob 2>&1 | grep hint
    = hint: write `--` to start a comment

A `:` after the patterns of a `case`:

  $ cat > case.frob << 'END'
  > data Way = Idle | Forward
  > 
  > main :: SF Way Int
  > main = arr (\w -> case w of
  >     Idle: 0
  >     Forward: 1)
  > END
  $ frobc check case.frob 2>&1 | grep -e ^error -e hint
  error[E0103]: unexpected character `:`
    = hint: write `->` after a pattern in a `case`: `Idle -> …`
  error[E0103]: unexpected character `:`
    = hint: write `->` after a pattern in a `case`: `Forward -> …`
  $ frobc fix --all case.frob > /dev/null 2>&1; frobc check case.frob

An `if` of C without `then`, tuples without parentheses, and a `switch` on a condition. Each hint
contains the code to paste:

  $ cat > branches.frob << 'END'
  > main :: SF Float Float
  > main = proc x -> y where
  >     y = if (x > 0) 1 else 2
  > END
  $ frobc check branches.frob 2>&1 | grep hint
    = hint: put `then` after the condition: `if x > 0 then 1 else 2`
  $ sed -i 's/if (x > 0) 1/if x > 0 then 1/' branches.frob && frobc check branches.frob
  $ printf 'main :: SF Float (Float, Float)\nmain = proc x -> if x > 0 then 1, 2 else 3, 4\n' > pair.frob
  $ frobc check pair.frob 2>&1 | grep hint
    = hint: put each tuple in parentheses, as in `then (1, 2) else …`
  $ sed -i 's/1, 2 else 3, 4/(1, 2) else (3, 4)/' pair.frob && frobc check pair.frob
  $ printf 'main :: SF Float Float\nmain = proc x -> v + w where\n    v, w = x, 2 * x\n' > names.frob
  $ frobc check names.frob 2>&1 | grep hint
    = hint: put a tuple pattern in parentheses: `(v, w) = (x, 2 * x)`
  $ sed -i 's/v, w = x, 2 \* x/(v, w) = (x, 2 * x)/' names.frob && frobc check names.frob
  $ printf 'main :: SF Float Float\nmain = proc x -> switch (x > 0) 1 2\n' > switch.frob
  $ frobc check switch.frob 2>&1 | grep hint
    = hint: to choose a value based on a condition, write `if x > 0 then 1 else 2`
  $ sed -i 's/switch (x > 0) 1 2/if x > 0 then 1 else 2/' switch.frob && frobc check switch.frob

Two robot commands in one instant:

  $ cat > commands.frob << 'END'
  > import Robot
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0.1[m/s] 0) >> roMake (setLight On))
  > END
  $ frobc check commands.frob 2>&1 | grep hint
    = hint: to give two robot commands at once, combine them with `.`: `roMake (setVelTR 0.1[m/s] 0 . setLight On)`
  $ sed -i 's/roMake (setVel.*/roMake (setVelTR 0.1[m\/s] 0 . setLight On))/' commands.frob && frobc check commands.frob
