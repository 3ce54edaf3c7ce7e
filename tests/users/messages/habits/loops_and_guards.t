Loops as values, `=` in guards, `return` in functions, labels without quotes. Each program is one or
several lines under an import; the test shows the message without the source, and checks the program
with the hint's text.

  $ try () { # SIGNATURE LINES CORRECTED-LINES
  >   printf "import Control\n$1\n$2\n" > program.frob
  >   frobc check program.frob 2>&1 | grep '^error\|hint\|^warning'
  >   printf "import Control\n$1\n$3\n" > corrected.frob
  >   frobc check corrected.frob 2>&1 | grep '^error'
  > }

A loop after the `=` of an equation:

  $ S='total :: Array 4 Float -> Float'
  $ try "$S" 'total row = for (int i = 0; i < 4; i++) s += row[i];' 'total row = foldl (+) 0 row'
  error[E0110]: Frob has no `for`
    = hint: write `foldl (+) 0 row` for the sum of an array, or `map f row` to compute a value for each element
  [1]
  $ try "$S" 'total row = y where\n    y = for (int i = 0; i < 4; i++) {\n        s += row[i];\n    }' 'total row = y where\n    y = foldl (+) 0 row'
  error[E0110]: Frob has no `for`
    = hint: write `foldl (+) 0 row` for the sum of an array, or `map f row` to compute a value for each element
  [1]
  $ try "$S" 'total row = for x in row' 'total row = foldl (+) 0 row'
  error[E0110]: Frob has no `for`
    = hint: write `foldl (+) 0 row` for the sum of an array, or `map f row` to compute a value for each element
  [1]
  $ try "$S" 'total row = for x in row:\n    s += x' 'total row = foldl (+) 0 row'
  error[E0103]: unexpected character `:`
    = hint: Frob has no `for`: write `foldl (+) 0 row` for the sum of an array, or `map f row` to compute a value for each element
  [1]
  $ try "$S" 'total row =\n    for i in range(4):\n        s = s + row[i]' 'total row =\n    foldl (+) 0 row'
  error[E0103]: unexpected character `:`
    = hint: Frob has no `for`: write `foldl (+) 0 row` for the sum of an array, or `map f row` to compute a value for each element
  [1]
  $ try "$S" 'total row = for (auto x : row) s += x' 'total row = foldl (+) 0 row'
  error[E0103]: unexpected character `:`
    = hint: Frob has no `for`: write `foldl (+) 0 row` for the sum of an array, or `map f row` to compute a value for each element
  [1]
  $ try "$S" 'total row = for i = 1:4 s = s + row(i) end' 'total row = foldl (+) 0 row'
  error[E0103]: unexpected character `:`
    = hint: Frob has no `for`: write `foldl (+) 0 row` for the sum of an array, or `map f row` to compute a value for each element
  [1]
  $ try 'f :: SF Float Float' 'f = proc x -> n where\n    n = while (x > 0) { n = n + 1 }' 'f = proc x -> n where\n    n = delay 0 (n + 1)'
  error[E0205]: unknown name `while`
    = hint: an equation has one value at every instant: for a value that changes over time, write, for example, `n = delay 0 (n + 1)`; to repeat a task, write `whileT condition t`
  [1]
  $ try 'f :: SF Float Float' 'f = proc x -> n where\n    n = while x > 0:\n        n += 1' 'f = proc x -> n where\n    n = delay 0 (n + 1)'
  error[E0103]: unexpected character `:`
    = hint: Frob has no `while`: an equation has one value at every instant: for a value that changes over time, write, for example, `n = delay 0 (n + 1)`; to repeat a task, write `whileT condition t`
  [1]

A loop on lines of its own:

  $ try "$S" 'total row = s\n    for x in row:\n        s = s + x' 'total row = foldl (+) 0 row'
  error[E0103]: unexpected character `:`
    = hint: Frob has no loops: write `map f row` or `foldl (+) 0 row` for an array, or `forEachT row f` to run a task for each element
  [1]
  $ try "$S" 'total row = s\n    for (int i = 0; i < 4; i++)\n        s += row[i];' 'total row = foldl (+) 0 row'
  error[E0110]: Frob has no `for`
    = hint: Frob has no loops: write `map f row` or `foldl (+) 0 row` for an array, or `forEachT row f` to run a task for each element
  [1]

A guard that compares with `=`:

  $ try 'sign :: Float -> Int' 'sign x\n    | x = 0     = 1\n    | x < 0     = -1\n    | otherwise = 0' 'sign x\n    | x == 0 = 1\n    | x < 0     = -1\n    | otherwise = 0'
  error[E0110]: a guard cannot contain `=`
    = hint: to compare, write `| x == 0 = 1`
  [1]
  $ try 'f :: Float -> Int' 'f x | x = 0 = 1\n    | otherwise = 2' 'f x | x == 0 = 1\n    | otherwise = 2'
  error[E0110]: a guard cannot contain `=`
    = hint: to compare, write `| x == 0 = 1`
  [1]
  $ try 'f :: Float -> Int' 'f x\n    | x = 0 && x < 1\n        = 1\n    | otherwise = 2' 'f x\n    | x == 0 && x < 1\n        = 1\n    | otherwise = 2'
  error[E0110]: a guard cannot contain `=`
    = hint: to compare, write `| x == 0 && x < 1`
  [1]
  $ try 'f :: Float -> Int' 'f x = case x of\n    y | y = 0 -> 1\n      | otherwise -> 2' 'f x = case x of\n    y | y == 0 -> 1\n      | otherwise -> 2'
  error[E0110]: a guard cannot contain `=`
    = hint: to compare, write `| y == 0 -> 1`
  [1]

A `return` before the value of a function:

  $ try 'smaller :: Float -> Float -> Float' 'smaller a b = return if a < b then a else b' 'smaller a b = if a < b then a else b'
  error[E0110]: `return` is only for tasks
    = hint: write `smaller a b = if a < b then a else b`
  [1]
  $ try 'smaller :: Float -> Float -> Float' 'smaller a b =\n    return if a < b then a else b' 'smaller a b =\n    if a < b then a else b'
  error[E0110]: `return` is only for tasks
    = hint: write `if a < b then a else b`, without `return`
  [1]
  $ try 'smaller :: Float -> Float -> Float' 'smaller a b = return case a < b of\n    True -> a\n    False -> b' 'smaller a b = case a < b of\n    True -> a\n    False -> b'
  error[E0110]: `return` is only for tasks
    = hint: write `smaller a b = case a < b of`
  [1]
  $ try 'f :: SF Float Float' 'f = proc x -> return if x < 0 then 1 else 2' 'f = proc x -> if x < 0 then 1 else 2'
  error[E0110]: `return` is only for tasks
    = hint: write `f = proc x -> if x < 0 then 1 else 2`
  [1]
  $ try 't :: Bool -> Task i o Bool' 't b = do\n    return if b then True else False' 't b = do\n    return (if b then True else False)'
  error[E0110]: the argument of `return` must be in parentheses
    = hint: write `return (if b then True else False)`
  [1]

A test whose label has no quotes; a function with the name `test` is no test:

  $ try 'half :: Float -> Float\nhalf x = x / 2' 'test halves = half 4 == 2' 'test "halves" = half 4 == 2'
  error[E0235]: the label of a `test` must be in quotes
    = hint: write `test "halves" = …`
  [1]
  $ try 'half :: Float -> Float\nhalf x = x / 2' 'test halves = half 4 > 1 && half 4 < 3' 'test "halves" = half 4 > 1 && half 4 < 3'
  error[E0235]: the label of a `test` must be in quotes
    = hint: write `test "halves" = …`
  [1]
  $ try 'half :: Float -> Float\nhalf x = x / 2' 'test x = half x == 2' 'test x = half x == 2'
  warning[W0306]: `Control` is imported, but nothing from it is used
    = hint: remove it
  [1]

Types in the notation of C++ and Haskell inside the arguments of a type:

  $ try '' 'f :: SF (vector<Float>) Float\nf = proc row -> sum row' 'f :: SF (Array n Float) Float\nf = proc row -> sum row'
  error[E0110]: type arguments are separated by spaces, not enclosed in `<>`
    = hint: write `f :: SF (Array 4 Float) Float`, if 4 is the number of elements
  [1]
  $ try '' 'f :: SF (list<Float>) Float\nf = proc row -> sum row' 'f :: SF (Array n Float) Float\nf = proc row -> sum row'
  error[E0110]: type arguments are separated by spaces, not enclosed in `<>`
    = hint: write `f :: SF (Array 4 Float) Float`, if 4 is the number of elements
  [1]
  $ try '' 'f :: SF (Array<Float, 4>) Float\nf = proc row -> sum row' 'f :: SF (Array 4 Float) Float\nf = proc row -> sum row'
  error[E0110]: type arguments are separated by spaces, not enclosed in `<>`
    = hint: write `f :: SF (Array 4 Float) Float`
  [1]
  $ try '' 'f :: SF [Float] Float\nf = proc row -> sum row' 'f :: SF (Array 4 Float) Float\nf = proc row -> sum row'
  error[E0110]: the type of an array cannot be written in brackets
    = hint: write `f :: SF (Array 4 Float) Float`, if 4 is the number of elements
  [1]

Two equations for a name; the bracket after the second belongs to the expression around them:

  $ R='main :: Program RobotInput RobotOutput\nmain = reactimateRobot (proc i -> roMake (setVelTR v 0) where'
  $ try "import Robot\n$R" '    v = 0\n    v = if frontSonar i > 0.5[m] then 0.3[m/s] else 0)' '    v = if frontSonar i > 0.5[m] then 0.3[m/s] else 0)'
  error[E0212]: `v` is defined twice here
    = hint: remove `v = 0`: the other equation defines `v` at every instant
  [1]
  $ try "import Robot\n$R" '    v = 0.3[m/s]\n    v = if bumped i then 0 else v)' '    v = if bumped i then 0 else 0.3[m/s])'
  error[E0212]: `v` is defined twice here
    = hint: write one equation, `v = if bumped i then 0 else 0.3[m/s]`, because an equation holds at every instant, unlike an assignment
  [1]

A `switch` of C with its branches; a trial without seeds:

  $ D='data Mode = Idle | Driving\nspeed :: Mode -> Velocity'
  $ try "$D" 'speed mode = switch (mode) {\n    case Idle: 0\n    case Driving: 0.3[m/s]\n    }' 'speed mode = case mode of\n    Idle -> 0\n    Driving -> 0.3[m/s]'
  error[E0103]: unexpected character `:`
    = hint: to choose by value, write `case mode of`, and on separate lines below it, without braces, `Idle -> 0` and `Driving -> 0.3[m/s]`
  [1]
  $ try "$D" 'speed mode = switch (mode) {\n    case Idle: return 0;\n    default: return max(0, 0.3[m/s]); break;\n    }' 'speed mode = case mode of\n    Idle -> 0\n    _ -> max 0 0.3[m/s]'
  error[E0103]: unexpected character `:`
    = hint: to choose by value, write `case mode of`, and on separate lines below it, without braces, `Idle -> 0` and `_ -> max 0 0.3[m/s]`
  error[E0110]: expected `=`, `::`, or a parameter after this name, found the end of the definition
  [1]
  $ try "import Robot\nimport Trial\n$R" '    v = 0.3[m/s])\ntrial "stays" = Trial { world = "room.toml", lasts = 60[s], judge = neverTouches }' '    v = 0.3[m/s])\ntrial "stays" = Trial { world = "room.toml", lasts = 60[s], judge = neverTouches, seeds = 1 `to` 10 }'
  error[E0228]: this `Trial` is missing the field `seeds`
     = hint: give every field a value: add ``seeds = 1 `to` 10``
  [1]

An anonymous function in place of a `proc`:

  $ try 'import Robot\nf :: SF RobotInput Distance' 'f = \\i -> 2 * ahead where\n    ahead = frontSonar i' 'f = proc i -> 2 * ahead where\n    ahead = frontSonar i'
  error[E0205]: unknown name `i`
    = hint: for a signal function, write `proc i -> …`
  [1]
  $ try 'f :: Float -> Float' 'f = \\x -> 2 * y where\n    y = x + 1' 'f x = 2 * y where\n    y = x + 1'
  error[E0205]: unknown name `x`
    = hint: write the parameter on the left side of the equation: `f x = …`
  [1]
