Names from other languages: the message names Frob's equivalent. The hint for each name:

  $ hint() {
  >   for name in "$@"; do
  >     printf 'main :: SF Float Float\nmain = proc x -> %s x\n' "$name" > name.frob
  >     printf '%s: ' "$name"
  >     frobc check name.frob 2>&1 | sed -n 's/^  *= hint: //p'
  >   done
  > }

  $ hint ceil floorf trunc rint int toInt float
  ceil: use `ceiling` to get an Int, or `ceilingFloat` to get a Float
  floorf: use `floor` to get an Int, or `floorFloat` to get a Float
  trunc: use `truncate`, which returns an Int
  rint: use `round`, `floor`, `ceiling` or `truncate` to convert a Float to an Int
  int: use `round`, `floor`, `ceiling` or `truncate` to convert a Float to an Int
  toInt: use `round`, `floor`, `ceiling` or `truncate` to convert a Float to an Int
  float: write `toFloat x`
  $ hint pow powf sq exp2 ln log10 tanh fabs fmin fmaxf sgn sign copysign
  pow: write a power as `x ** y`, or as `x ^ 2` if the exponent is a literal
  powf: write a power as `x ** y`, or as `x ^ 2` if the exponent is a literal
  sq: write `x ^ 2`
  exp2: use `2 ** x`
  ln: write `log`
  log10: write `log x / log 10`, because `log` is the natural logarithm
  tanh: define it with `exp`; for example, tanh x is `1 - 2 / (exp (2 * x) + 1)`
  fabs: write `abs`
  fmin: write `min`
  fmaxf: write `max`
  sgn: write `signum`
  sign: write `signum`
  copysign: use `if y < 0 then -(abs x) else abs x`
  $ hint fmod remainder rem quot even odd constrain clip lerp
  fmod: for Floats, write `x - y * floorFloat (x / y)`, whose result has the sign of `y`; for angles, use `wrapAngle`
  remainder: for Floats, write `x - y * floorFloat (x / y)`, whose result has the sign of `y`; for angles, use `wrapAngle`
  rem: for Ints, use `div` and `mod`; division rounds towards minus infinity
  quot: for Ints, use `div` and `mod`; division rounds towards minus infinity
  even: use `mod n 2 == 0`
  odd: use `mod n 2 == 1`
  constrain: use `clamp low high x`, with `import Control`
  clip: use `clamp low high x`, with `import Control`
  lerp: use `a + t * (b - a)`
  $ hint isnan nan isinf isfinite NAN INFINITY
  isnan: to test for NaN, write `x /= x`; to get NaN, write `(0 / 0)`
  nan: to test for NaN, write `x /= x`; to get NaN, write `(0 / 0)`
  isinf: to test whether x is finite, write `x - x == 0`; for the value infinity, write `(1 / 0)`
  isfinite: to test whether x is finite, write `x - x == 0`; for the value infinity, write `(1 / 0)`
  NAN: use `(0 / 0)` for NaN
  INFINITY: use `(1 / 0)` for infinity
  $ hint PI M_PI TWO_PI HALF_PI deg2rad radians rad2deg degrees
  PI: write `pi`
  M_PI: write `pi`
  TWO_PI: use `2 * pi`
  HALF_PI: use `pi / 2`
  deg2rad: write `x * 1[deg]`
  radians: write `x * 1[deg]`
  rad2deg: write `x / 1[deg]`
  degrees: write `x / 1[deg]`
  $ hint wrapToPi normalize_angle shortest_angular_distance math.sqrt Math.sqrt np.abs random
  wrapToPi: write `wrapAngle x`, with `import Geometry`
  normalize_angle: write `wrapAngle x`, with `import Geometry`
  shortest_angular_distance: use `angleDiff a b`, with `import Geometry`
  math.sqrt: write `sqrt x`, without `math.`
  Math.sqrt: mathematical functions are built in: write `sqrt x`
  np.abs: write `abs x`, without `np.`
  random: use `whiteNoise 1 ()`, with `import Sources`; 1 is the seed, and each run has the same noise
  $ hint minimum maximum average len enumerate zeros append null TRUE
  minimum: write `minimumBy id x`
  maximum: write `maximumBy id x`
  average: write `mean x`
  len: write `length x`
  enumerate: write `imap (\i x -> (i, x)) x`
  zeros: use `generate (const 0)`; the number of elements comes from its type
  append: the size of an array is fixed; to change the element at index i, write `replace i x xs`
  null: write `Nothing` for a missing value; the type of a value that may be missing is `Maybe a`
  TRUE: write `True`
  $ hint millis micros delayMicroseconds digitalWrite analogRead for undefined
  millis: use `time ()` for the time since the start, which has a unit, as in `1[s]`; the event `after 1[s] ()` occurs once, 1 s after the start, and `every 1[s] ()` occurs every second
  micros: use `time ()` for the time since the start, which has a unit, as in `1[s]`; the event `after 1[s] ()` occurs once, 1 s after the start, and `every 1[s] ()` occurs every second
  delayMicroseconds: to wait in a task with the robot at rest, write `sleepT 2[s] restingOutput`
  digitalWrite: a program writes pins through its output: add a field for the value to the output's type, or combine robot commands, as in `roMake (setVelTR v omega . setLight On)`
  analogRead: a program reads pins through its input: add a field for the value to the input's type, and read the field, as in `proc i -> i.light > 0.5`; a robot's sensors are signal functions, such as `frontSonar i`
  for: to compute something for each element, write `map f xs`; to run a task for each, write `forEachT xs f`
  undefined: a program never aborts: use `Maybe` for a value that may be absent
  $ hint pre integrate deriv
  pre: use `delay x0`, where `x0` is the first value
  integrate: write `integral`
  deriv: write `derivative`

A similar name in the program or the library is still suggested if no other language has it:

  $ hint atan3 sqrtf constan
  atan3: did you mean `atan`?
  sqrtf: did you mean `sqrt`?
  constan: did you mean `constant`?

The hints are correct:

  $ cat > right.frob <<'FROB'
  > import Control
  > import Geometry
  > type Eight = 8
  > whole :: Float -> Int -> (Int, Float, Int, Float, Int, Float, Bool, Bool)
  > whole x n = (ceiling x, ceilingFloat x, floor x, floorFloat x, truncate x, toFloat n, mod n 2 == 0, mod n 2 == 1)
  > powers :: Float -> Float -> (Float, Float, Float, Float, Float, Float, Float)
  > powers x y =
  >     (x ** y, x ^ 2, 2 ** x, log x / log 10, 1 - 2 / (exp (2 * x) + 1), signum x, if y < 0 then -(abs x) else abs x)
  > rest :: Float[u] -> Float[u] -> Float[u]
  > rest x y = x - y * floorFloat (x / y)
  > between :: Float[u] -> Float[u] -> Float -> Float[u]
  > between a b t = clamp a b (a + t * (b - a))
  > odd :: Float -> (Bool, Bool, Float, Float)
  > odd x = (x /= x, x - x == 0, 0 / 0, 1 / 0)
  > angles :: Float -> Angle -> (Angle, Angle, Float, Angle, Float, Float)
  > angles x a = (90[deg], x * 1[deg], a / 1[deg], wrapAngle a, angleDiff x a, 2 * pi - pi / 2)
  > arrays :: Array Eight Float -> (Float, Float, Float, Array Eight (Int, Float), Array Eight Float, Array Eight Float)
  > arrays xs =
  >     ( minimumBy id xs, maximumBy id xs, foldl (+) 0 xs / toFloat (length xs), imap (\i x -> (i, x)) xs
  >     , generate (const 0), replace 2 1 xs )
  > main :: SF Float Float
  > main = proc x -> time () / 1[s] + delay 0 x
  > FROB
  $ frobc check right.frob
