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
  error[E0110]: expected `=` after the left side of a definition, found the end of the definition
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
    = hint: write `vMax = …`; to give its type, write `vMax :: Velocity` on a line of its own above it
  [1]
  $ try '' 'f(Distance d, Velocity v) = d / v' 'f :: Distance -> Velocity -> Time\nf d v = d / v'
  error[E0206]: a parameter cannot have a type
    = hint: write `f d v = d / v`, and the types in a signature above it: `f :: Distance -> Velocity -> …`
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
