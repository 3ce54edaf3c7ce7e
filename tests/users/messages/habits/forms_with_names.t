Hints that contain the names, arguments and types of the program. Each program is given by its
lines; the test shows the hints, and checks the program with the lines that the hint suggests.

  $ try () { # PROGRAM CORRECTED-PROGRAM
  >   printf "$1"'\n' > program.frob
  >   frobc check program.frob 2>&1 | grep '^error\|hint'
  >   printf "$2"'\n' > corrected.frob; frobc check corrected.frob 2>&1 | grep '^error'
  > }

A parameter without a unit in the signature:

  $ try 'f :: Float -> Distance -> AngularVelocity\nf k e = k * e' 'f :: Float[1/m/s] -> Distance -> AngularVelocity\nf k e = k * e'
  error[E0320]: expected the unit `1/s`, found `m`
    = hint: if `k` has a unit, write the signature as `f :: Float[1/m/s] -> Distance -> AngularVelocity`
    = hint: if this is the right result, write the signature as `f :: Float -> Distance -> Float[m]`
  [1]
  $ try 'f :: Float -> SF Distance Velocity\nf k = proc d -> k * d' 'f :: Float[1/s] -> SF Distance Velocity\nf k = proc d -> k * d'
  error[E0320]: expected the unit `m/s`, found `m`
    = hint: if `k` has a unit, write the signature as `f :: Float[1/s] -> SF Distance Velocity`
    = hint: if this is the right result, write the signature as `f :: Float -> SF Distance Float[m]`
  [1]

Arrays and events:

  $ M='f :: SF (Array 3 Float, Array 3 Float) (Array 3 Float)\nf = proc (a, b) ->'
  $ try "$M a + b" "$M zipWith (+) a b"
  error[E0301]: expected a number, found `Array 3 Float`
    = hint: to compute with the elements of two arrays, write `zipWith (+) a b`
  [1]
  $ M='f :: SF (Event Float) (Event Float)\nf = proc e ->'
  $ try "$M map (2 *) e" "$M mapE (2 *) e"
  error[E0301]: expected `Array m n[u]`, found `Event Float`
    = hint: to apply a function to an event's value, write `mapE (2 *) e`
  [1]
  $ M='f :: SF (Bool, Bool) (Event ())\nf = proc (a, b) ->'
  $ try "$M edge a || edge b" "$M mergeE (edge a) (edge b)"
  error[E0301]: expected `Bool`, found `Event ()`
    = hint: use `mergeE (edge a) (edge b)`, which occurs when either event does
  [1]
  $ try 'f :: Int\nf = sum [1..4]' 'f :: Int\nf = sum [1, 2, 3, 4]'
  error[E0110]: Frob has no `..`
    = hint: Frob has no ranges: write the elements, `[1, 2, 3, 4]`
  [1]

Functions, guards and records:

  $ try 'import Robot\nmain :: Program RobotInput RobotOutput\nmain = reactimateRobot (\\_ -> restingOutput)' 'import Robot\nmain :: Program RobotInput RobotOutput\nmain = reactimateRobot (proc _ -> restingOutput)'
  error[E0304]: expected a signal function, found a function: `c -> d`
    = hint: write `proc _ -> …` in place of `\_ -> …`
  [1]
  $ try 'f :: SF Float Float\nf = proc x abs x' 'f :: SF Float Float\nf = proc x -> abs x'
  error[E0110]: expected `->` after the input of this `proc`, found `abs`
    = hint: put `->` after the input: `proc x -> …`
  [1]
  $ try 'f :: Float -> Float\nf x\n    | if x > 0 = 1\n    | otherwise = 0' 'f :: Float -> Float\nf x\n    | x > 0 = 1\n    | otherwise = 0'
  error[E0110]: expected `then` after the condition, found `=`
    = hint: a guard needs no `if`: use `| x > 0 = …`
  [1]
  $ try 'data P = P { x :: Float, y :: Float }\nf :: P\nf = P { 0, 1 }' 'data P = P { x :: Float, y :: Float }\nf :: P\nf = P { x = 0, y = 1 }'
  error[E0110]: expected the name of a field, found the number `0`
    = hint: write the name of the field before each value: `P { x = 0, y = 1 }`
  [1]
  $ try 'data Box a = Box { value :: a }\nf :: Box -> Float\nf b = b.value' 'data Box a = Box { value :: a }\nf :: Box Float -> Float\nf b = b.value'
  error[E0216]: type `Box` takes 1 type argument, not 0
    = hint: give it 1 type argument, as in `Box Float`
  [1]
  $ try 'f :: Bool -> Float\nf b = case b of\n    1 -> 1\n    _ -> 0' 'f :: Bool -> Float\nf b = case b of\n    True -> 1\n    False -> 0'
  error[E0301]: this pattern matches a number, but the value is `Bool`
    = hint: match a `Bool` with `True` and `False`, or choose with `if`
  [1]
  $ try 'k :: Float\nk = 2\nf :: Float -> Float\nf x = self.k * x' 'k :: Float\nk = 2\nf :: Float -> Float\nf x = k * x'
  error[E0205]: unknown name `self`
    = hint: Frob has no objects with methods: write `k` alone
  [1]

Modules, units and brackets:

  $ try 'import Control as c\nf :: Float\nf = 1' 'import Control as C\nf :: Float\nf = 1'
  error[E0110]: expected an alias for the module, starting with a capital letter, found `c`
    = hint: start the module's alias with a capital letter: `C`
  [1]
  $ try 'f :: Velocity\nf = 3[m s-1]' 'f :: Velocity\nf = 3[m s^-1]'
  error[E0110]: expected `^`, another factor of the unit, or the end of the unit, found `-`
    = hint: write a `^` before an exponent: `s^-1`
  [1]
  $ M='import Robot\nmain :: Program RobotInput RobotOutput\nmain = reactimateRobot (proc i -> roMake (setVelTR v 0)'
  $ try "$M)\n    where\n    v = 0.5[1/s] * frontSonar i" "$M\n    where\n    v = 0.5[1/s] * frontSonar i)"
  error[E0205]: unknown name `i`
    = hint: the bracket before this `where` ends the `proc`, so the equations after `where` cannot use the signals of the `proc`: move that bracket to the end of the last equation
  [1]
  $ M='import Control\nf :: SF Float Float\nf = proc x ->'
  $ try "$M constrain x 0 1" "$M clamp 0 1 x"
  error[E0205]: unknown name `constrain`
    = hint: write `clamp 0 1 x`
  [1]
  $ try "$M lowPassFilter 0.5[s] x" "$M lowPass 0.5[s] x"
  error[E0205]: unknown name `lowPassFilter`
    = hint: write `lowPass 0.5[s] x`
  [1]
