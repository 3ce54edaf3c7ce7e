Declarations and calls in the notation of C, C++ and Python. The hint contains the user's own
expression in Frob. Each program is one or several lines under an import; the test shows the message
without the source, and checks the program with the hint's text.

  $ try () { # SIGNATURE LINES CORRECTED-LINES
  >   printf "import Control\n$1\n$2\n" > program.frob
  >   frobc check program.frob 2>&1 | grep '^error\|hint'
  >   printf "import Control\n$1\n$3\n" > corrected.frob
  >   frobc check corrected.frob 2>&1 | grep '^error'
  > }

A type before the name that an equation defines:

  $ try 'f :: SF Distance Velocity' 'f = proc d -> v where\n    Velocity v = min 0.3[m/s] (d / 1[s])' 'f = proc d -> v where\n    v :: Velocity\n    v = min 0.3[m/s] (d / 1[s])'
  error[E0206]: an equation cannot start with a type
    = hint: write `v = min 0.3[m/s] (d / 1[s])`; to give its type, write `v :: Velocity` on a line of its own above it
  [1]
  $ try 'f :: SF Distance Velocity' 'f = proc d -> v where\n    const Float[m/s] v = d / 1[s];' 'f = proc d -> v where\n    v :: Float[m/s]\n    v = d / 1[s]'
  error[E0110]: an equation cannot start with a type
    = hint: write `v = d / 1[s]`; to give its type, write `v :: Float[m/s]` on a line of its own above it
  [1]
  $ try 'f :: SF Distance Velocity' 'f = proc d -> v where\n    const Velocity v = d / 1[s];' 'f = proc d -> v where\n    v :: Velocity\n    v = d / 1[s]'
  error[E0206]: an equation cannot start with a type
    = hint: write `v = d / 1[s]`; to give its type, write `v :: Velocity` on a line of its own above it
  [1]
  $ try 'f :: Float' 'f = sum xs where\n    Array 4 Float xs = [1, 2, 3, 4]' 'f = sum xs where\n    xs :: Array 4 Float\n    xs = [1, 2, 3, 4]'
  error[E0206]: an equation cannot start with a type
    = hint: write `xs = [1, 2, 3, 4]`; to give its type, write `xs :: Array 4 Float` on a line of its own above it
  [1]
  $ try 'f :: SF Distance Velocity' 'f = proc d -> v where\n    float v = d / 1[s]' 'f = proc d -> v where\n    v = d / 1[s]'
  error[E0205]: unknown name `v`
    = hint: write `v = d / 1[s]`, without a type
  [1]
  $ try 'f :: SF Distance Velocity' 'f = proc d -> v where\n    v: Velocity = d / 1[s]' 'f = proc d -> v where\n    v :: Velocity\n    v = d / 1[s]'
  error[E0103]: unexpected character `:`
    = hint: write `v = d / 1[s]`; to give its type, write `v :: Velocity` on a line of its own above it
  [1]
  $ try 'f :: SF Distance Velocity' 'f = proc d -> v where\n    Velocity v = if d > 1[m]\n        then 1[m/s]\n        else 0' 'f = proc d -> v where\n    v :: Velocity\n    v = if d > 1[m]\n        then 1[m/s]\n        else 0'
  error[E0206]: an equation cannot start with a type
    = hint: write `v = …`; to give its type, write `v :: Velocity` on a line of its own above it
  [1]
  $ try 'f :: SF Distance Velocity' 'f = proc d -> v where\n    Velocity v\n    v = d / 1[s]' 'f = proc d -> v where\n    v :: Velocity\n    v = d / 1[s]'
  error[E0110]: expected `=` after the left-hand side of a definition, found the end of the definition
    = hint: write the type after the name: `v :: Velocity`
  [1]
  $ try 'f :: Distance -> Velocity' 'f d =\n    let Velocity v = d / 1[s] in 2 * v' 'f d =\n    let v = d / 1[s] in 2 * v'
  error[E0206]: an equation cannot start with a type
    = hint: write `let v = d / 1[s]`, without a type
  [1]
  $ try 'import Robot\nt :: (HasSonar i, DiffDrive o) => Task i o Bool' 't = do\n    Distance d <- ask frontSonar\n    forward d' 't = do\n    d <- ask frontSonar\n    forward d'
  error[E0206]: a statement cannot start with a type
    = hint: write `d <- ask frontSonar`, without a type
  [1]
  $ try '' 'Velocity vMax = 0.3[m/s]' 'vMax :: Velocity\nvMax = 0.3[m/s]'
  error[E0226]: a top-level definition defines one name, not a pattern
    = hint: write `vMax = …`; to declare its type, write `vMax :: Velocity` on the line above
  [1]
  $ try '' 'f(Distance d, Velocity v) = d / v' 'f :: Distance -> Velocity -> Time\nf d v = d / v'
  error[E0206]: a parameter cannot have a type
    = hint: write `f d v = d / v`, and put the types in a signature above it: `f :: Distance -> Velocity -> …`
  [1]

Functions of mathematical modules:

  $ try 'f :: Angle -> Float' 'f a = 2 * math.cos a' 'f a = 2 * cos a'
  error[E0205]: unknown name `math`
    = hint: write `cos a`, without `math.`
  [1]
  $ try 'f :: Angle -> Float' 'f a = math.cos(a) * 2' 'f a = cos a * 2'
  error[E0205]: unknown name `math`
    = hint: write `cos a`, without `math.`
  [1]
  $ try 'f :: Float -> Float' 'f x = math.sqrt (2 * math.fabs x)' 'f x = sqrt (2 * abs x)'
  error[E0205]: unknown name `math`
    = hint: write `sqrt (2 * abs x)`, without `math.`
  error[E0205]: unknown name `math`
    = hint: write `abs x`, without `math.`
  [1]
  $ try 'f :: Array 3 Float -> Array 3 Float' 'f xs = map math.fabs xs' 'f xs = map abs xs'
  error[E0205]: unknown name `math`
    = hint: write `abs`, without `math.`
  [1]
  $ try 'f :: Float -> Float' 'f x = np.clip x 0 1' 'f x = clamp 0 1 x'
  error[E0205]: unknown name `np`
    = hint: write `clamp 0 1 x`
  [1]
  $ try 'f :: Float -> Float -> Angle' 'f y x = np.arctan2(y, x)' 'f y x = atan2 y x'
  error[E0205]: unknown name `np`
    = hint: write `atan2 y x`, without `np.`
  [1]
  $ try 'f :: Array 3 Float -> Float' 'f xs = np.linalg.norm xs' 'f xs = sqrt (sum (map (\\x -> x ^ 2) xs))'
  error[E0205]: unknown name `np`
    = hint: write `sqrt (sum (map (\x -> x ^ 2) xs))`, without `np.`
  [1]
  $ try 'f :: Array 2 Float -> Array 2 Float -> Float' 'f a b = np.dot(a, b)' 'f a b = sum (zipWith (*) a b)'
  error[E0205]: unknown name `np`
    = hint: write `sum (zipWith (*) a b)`, without `np.`
  [1]
  $ try 'f :: Array 3 Float -> Float' 'f xs = np.max(xs)' 'f xs = maximumBy id xs'
  error[E0205]: unknown name `np`
    = hint: write `maximumBy id xs`, without `np.`
  [1]
  $ try 'f :: Angle -> Float' 'f a = math.degrees a' 'f a = a / 1[deg]'
  error[E0205]: unknown name `math`
    = hint: write `a / 1[deg]`, without `math.`
  [1]
  $ try 'f :: Float -> Float' 'f x = math.log10 x' 'f x = log x / log 10'
  error[E0205]: unknown name `math`
    = hint: write `log x / log 10`, without `math.`
  [1]
  $ try 'f :: Angle -> Float' 'f a = Math.cos a' 'f a = cos a'
  error[E0215]: no module `Math` is imported here
    = hint: mathematical functions are built in: write `cos a`
  [1]
  $ try 'f :: Float' 'f = 2 * Math.PI' 'f = 2 * pi'
  error[E0215]: no module `Math` is imported here
    = hint: mathematical functions are built in: write `pi`
  [1]
  $ try 'f :: Float -> Float' 'f x = std::max(0, 2 * x)' 'f x = max 0 (2 * x)'
  error[E0110]: Frob has no `std::`
    = hint: write `max 0 (2 * x)`, without `std::`
  [1]
  $ try 'f :: Float -> Float' 'f x = std::clamp(x, 0, 1)' 'f x = clamp 0 1 x'
  error[E0110]: Frob has no `std::`
    = hint: write `clamp 0 1 x`, without `std::`; it needs `import Control`
  [1]
  $ try 'f :: Float -> Float' 'f x = std::pow(x, 2) + 1' 'f x = x ^ 2 + 1'
  error[E0110]: Frob has no `std::`
    = hint: write `x ^ 2`, without `std::`
  [1]
  $ try 'f :: Float -> Float' 'f x = std::max 0 x' 'f x = max 0 x'
  error[E0110]: Frob has no `std::`
    = hint: write `max`, without `std::`
  [1]

Arrays and numbers that other languages generate:

  $ try 'f :: Array 4 Int' 'f = range(4)' 'f = [0, 1, 2, 3]'
  error[E0205]: unknown name `range`
    = hint: write `[0, 1, 2, 3]`: an array literal lists its elements
  [1]
  $ try 'f :: SF (Array 4 Float) (Array 4 Float)' 'f = proc x -> y where\n    y = zipWith (+) x (delay zeros(1, 4) y)' 'f = proc x -> y where\n    y = zipWith (+) x (delay [0, 0, 0, 0] y)'
  error[E0205]: unknown name `zeros`
    = hint: write `[0, 0, 0, 0]`: an array literal lists its elements
  [1]
  $ try 'f :: Array 2 (Array 2 Float)' 'f = np.zeros((2, 2))' 'f = [[0, 0], [0, 0]]'
  error[E0205]: unknown name `np`
    = hint: write `[[0, 0], [0, 0]]`: an array literal lists its elements
  [1]
  $ try 'f :: SF (Array 100 Float) (Array 100 Float)' 'f = proc x -> delay zeros(100) x' 'f = proc x -> delay (generate (const 0)) x'
  error[E0205]: unknown name `zeros`
    = hint: write `(generate (const 0))`: its type determines the number of elements
  [1]
  $ try 'f :: Array 3 Float' 'f = replicate 3 0.5' 'f = [0.5, 0.5, 0.5]'
  error[E0205]: unknown name `replicate`
    = hint: write `[0.5, 0.5, 0.5]`: an array literal lists its elements
  [1]
  $ try 'f :: Array 2 (Array 2 Float)' 'f = [0, -1; 1, 0]' 'f = [[0, -1], [1, 0]]'
  error[E0111]: separate array elements with `,`, not `;`
    = hint: the rows of a matrix are arrays: write `[[0, -1], [1, 0]]`
  [1]
  $ try 'f :: Array 2 (Array 2 Float)' 'f = [0 -1; 1 0]' 'f = [[0, -1], [1, 0]]'
  error[E0111]: separate array elements with `,`, not `;`
    = hint: the rows of a matrix are arrays: write `[[0, -1], [1, 0]]`
  [1]
  $ try 'f :: Array 3 Float' 'f = [1; 2; 3]' 'f = [1, 2, 3]'
  error[E0111]: separate array elements with `,`, not `;`
    = hint: write `[1, 2, 3]`
  [1]
  $ T='import Robot\nimport Trial\nmain :: Program RobotInput RobotOutput\nmain = reactimateRobot (proc i -> roMake (setVelTR 0 0))\ntrial "stays" = Trial { world = "room.toml", lasts = 60[s], judge = neverTouches,'
  $ try "$T" '    seeds = range(1, 20) }' '    seeds = 1 `to` 19 }'
  error[E0205]: unknown name `range`
    = hint: write ``1 `to` 19``, which includes both numbers
  [1]
  $ try "$T" '    seeds = 1:20 }' '    seeds = 1 `to` 20 }'
  error[E0103]: unexpected character `:`
    = hint: write ``1 `to` 20`` without brackets; it includes both numbers
  [1]
  $ try "$T" '    seeds = [1:20] }' '    seeds = 1 `to` 20 }'
  error[E0103]: unexpected character `:`
    = hint: write ``1 `to` 20`` without brackets; it includes both numbers
  [1]

Choices:

  $ D='data Colour = Red | Green\nf :: Colour -> Velocity'
  $ try "$D" 'f c = switch c of\n    Red -> 0\n    Green -> 1[m/s]' 'f c = case c of\n    Red -> 0\n    Green -> 1[m/s]'
  error[E0110]: to choose by value, Frob has `case`, not `switch`
    = hint: write `case c of`; `switch` changes from one signal function to another
  [1]
  $ try "$D" 'f c = 2 * (match c of\n    Red -> 0\n    Green -> 1[m/s])' 'f c = 2 * (case c of\n    Red -> 0\n    Green -> 1[m/s])'
  error[E0110]: to choose by value, Frob has `case`, not `match`
    = hint: write `case c of`
  [1]
  $ try "$D" 'f c = switch c\n    Red -> 0\n    Green -> 1[m/s]' 'f c = case c of\n    Red -> 0\n    Green -> 1[m/s]'
  error[E0110]: to choose by value, Frob has `case`, not `switch`
    = hint: write `case c of`; `switch` changes from one signal function to another
  [1]
  $ try 'f :: Bool -> Velocity' 'f b = v where\n    v = if b:\n            0\n        else:\n            0.3[m/s]' 'f b = v where\n    v = if b then 0 else 0.3[m/s]'
  error[E0103]: unexpected character `:`
    = hint: write the choice as `if b then 0 else 0.3[m/s]`
  [1]
  $ try 'f :: Float -> Float' 'f x =\n    if x > 0:\n        return 1\n    elif x < 0:\n        return 2\n    else:\n        return 3' 'f x =\n    if x > 0 then 1 else if x < 0 then 2 else 3'
  error[E0103]: unexpected character `:`
    = hint: write the choice as `if x > 0 then 1 else if x < 0 then 2 else 3`
  [1]
  $ try 'f :: Float -> Float' 'f x = y where\n    y = 2 * x\n    end' 'f x = y where\n    y = 2 * x'
  error[E0110]: Frob has no `end`
    = hint: remove this line: a block ends where its indentation ends
  [1]

Types with arguments, parameters, keyword arguments:

  $ try '' 'f :: Array<Float, 4> -> Float\nf xs = sum xs' 'f :: Array 4 Float -> Float\nf xs = sum xs'
  error[E0110]: expected `->` or the end of this type, found `<`
    = hint: separate type arguments with spaces, without `<>`: write `f :: Array 4 Float -> Float`
  [1]
  $ try '' 'f :: std::array<double, 4> -> Float\nf xs = sum xs' 'f :: Array 4 Float -> Float\nf xs = sum xs'
  error[E0110]: Frob has no `std::`
    = hint: separate type arguments with spaces, without `<>`: write `f :: Array 4 Float -> Float`
  [1]
  $ try '' 'f :: Maybe<Float[m]> -> Distance\nf m = fromMaybe 0 m' 'f :: Maybe Float[m] -> Distance\nf m = fromMaybe 0 m'
  error[E0110]: expected `->` or the end of this type, found `<`
    = hint: separate type arguments with spaces, without `<>`: write `f :: Maybe Float[m] -> Distance`
  [1]
  $ try '' 'f :: SF<Event<Float>, Float>\nf = proc e -> hold 0 e' 'f :: SF (Event Float) Float\nf = proc e -> hold 0 e'
  error[E0110]: expected `->` or the end of this type, found `<`
    = hint: separate type arguments with spaces, without `<>`: write `f :: SF (Event Float) Float`
  [1]
  $ try '' 'f :: SF (Event<Float>) Float\nf = proc e -> hold 0 e' 'f :: SF (Event Float) Float\nf = proc e -> hold 0 e'
  error[E0110]: type arguments are separated by spaces, not enclosed in `<>`
    = hint: write `f :: SF (Event Float) Float`
  [1]
  $ try '' 'param "speed" :: Velocity = 0.3[m/s]' 'param speed :: Velocity = 0.3[m/s]'
  error[E0110]: the name of a parameter must be written without quotes
    = hint: write `param speed :: Velocity = 0.3[m/s]`
  [1]
  $ try '' 'param "speed" = 0.3[m/s]' 'param speed :: Float[m/s] = 0.3[m/s]'
  error[E0110]: the name of a parameter must be written without quotes
    = hint: write `param speed :: Float[m/s] = 0.3[m/s]`
  [1]
  $ try '' 'param Velocity speed = 0.3[m/s]' 'param speed :: Velocity = 0.3[m/s]'
  error[E0110]: the name of a parameter must come before its type
    = hint: write `param speed :: Velocity = 0.3[m/s]`
  [1]
  $ try '' 'param speed: Velocity = 0.3[m/s]' 'param speed :: Velocity = 0.3[m/s]'
  error[E0103]: unexpected character `:`
    = hint: write `param speed :: Velocity = 0.3[m/s]`
  [1]
  $ try 'f :: Float -> Float' 'f x = clamp(low=0, high=1, x=2 * x)' 'f x = clamp 0 1 (2 * x)'
  error[E0110]: expected an operator, `,` or `)`, found `=`
    = hint: arguments are passed by position, not by name: write `clamp 0 1 (2 * x)`
  [1]
