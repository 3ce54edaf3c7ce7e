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
    = hint: write `foldl (+) 0 row` for the sum of an array, `map f row` to compute something for each element
  [1]
  $ try "$S" 'total row = y where\n    y = for (int i = 0; i < 4; i++) {\n        s += row[i];\n    }' 'total row = y where\n    y = foldl (+) 0 row'
  error[E0110]: Frob has no `for`
    = hint: write `foldl (+) 0 row` for the sum of an array, `map f row` to compute something for each element
  [1]
  $ try "$S" 'total row = for x in row' 'total row = foldl (+) 0 row'
  error[E0110]: Frob has no `for`
    = hint: write `foldl (+) 0 row` for the sum of an array, `map f row` to compute something for each element
  [1]
  $ try "$S" 'total row = for x in row:\n    s += x' 'total row = foldl (+) 0 row'
  error[E0103]: unexpected character `:`
    = hint: Frob has no `for`: write `foldl (+) 0 row` for the sum of an array, `map f row` to compute something for each element
  [1]
  $ try "$S" 'total row =\n    for i in range(4):\n        s = s + row[i]' 'total row =\n    foldl (+) 0 row'
  error[E0103]: unexpected character `:`
    = hint: Frob has no `for`: write `foldl (+) 0 row` for the sum of an array, `map f row` to compute something for each element
  [1]
  $ try "$S" 'total row = for (auto x : row) s += x' 'total row = foldl (+) 0 row'
  error[E0103]: unexpected character `:`
    = hint: Frob has no `for`: write `foldl (+) 0 row` for the sum of an array, `map f row` to compute something for each element
  [1]
  $ try "$S" 'total row = for i = 1:4 s = s + row(i) end' 'total row = foldl (+) 0 row'
  error[E0103]: unexpected character `:`
    = hint: Frob has no `for`: write `foldl (+) 0 row` for the sum of an array, `map f row` to compute something for each element
  [1]
  $ try 'f :: SF Float Float' 'f = proc x -> n where\n    n = while (x > 0) { n = n + 1 }' 'f = proc x -> n where\n    n = delay 0 (n + 1)'
  error[E0205]: unknown name `while`
    = hint: an equation has one value at every instant; for a value that changes over time write, for example, `n = delay 0 (n + 1)`; to repeat a task, write `whileT condition t`
  [1]
  $ try 'f :: SF Float Float' 'f = proc x -> n where\n    n = while x > 0:\n        n += 1' 'f = proc x -> n where\n    n = delay 0 (n + 1)'
  error[E0103]: unexpected character `:`
    = hint: Frob has no `while`: an equation has one value at every instant; for a value that changes over time write, for example, `n = delay 0 (n + 1)`; to repeat a task, write `whileT condition t`
  [1]

A loop on lines of its own:

  $ try "$S" 'total row = s\n    for x in row:\n        s = s + x' 'total row = foldl (+) 0 row'
  error[E0103]: unexpected character `:`
    = hint: Frob has no loops: write `map f row` or `foldl (+) 0 row` for an array, `forEachT row f` to run a task for each element
  [1]
  $ try "$S" 'total row = s\n    for (int i = 0; i < 4; i++)\n        s += row[i];' 'total row = foldl (+) 0 row'
  error[E0110]: Frob has no `for`
    = hint: Frob has no loops: write `map f row` or `foldl (+) 0 row` for an array, `forEachT row f` to run a task for each element
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
  warning[W0306]: `Control` is imported but nothing from it is used
    = hint: remove it
  [1]
