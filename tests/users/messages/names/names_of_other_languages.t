Names that other languages have are answered with what they are here. Of each name, the hint:

  $ hint() {
  >   for name in "$@"; do
  >     printf 'main :: SF Float Float\nmain = proc x -> %s x\n' "$name" > name.frob
  >     printf '%s: ' "$name"
  >     frobc check name.frob 2>&1 | sed -n 's/^  *= hint: //p'
  >   done
  > }

  $ hint ceil floorf trunc rint int toInt float
  ceil: `ceiling` makes an Int, `ceilingFloat` a Float
  floorf: `floor` makes an Int, `floorFloat` a Float
  trunc: it is `truncate`, which makes an Int
  rint: `round`, `floor`, `ceiling` and `truncate` make an Int of a Float
  int: `round`, `floor`, `ceiling` and `truncate` make an Int of a Float
  toInt: `round`, `floor`, `ceiling` and `truncate` make an Int of a Float
  float: `toFloat n` makes a Float of an Int
  $ hint pow powf sq exp2 ln log10 tanh fabs fmin fmaxf sgn sign copysign
  pow: a power is `x ** y`, or `x ^ 2` with a literal exponent
  powf: a power is `x ** y`, or `x ^ 2` with a literal exponent
  sq: it is `x ^ 2`
  exp2: it is `2 ** x`
  ln: it is `log`
  log10: the natural logarithm is `log`: to the base 10 it is `log x / log 10`
  tanh: it is made of `exp`: tanh x is `1 - 2 / (exp (2 * x) + 1)`
  fabs: it is `abs`
  fmin: it is `min`
  fmaxf: it is `max`
  sgn: it is `signum`
  sign: it is `signum`
  copysign: it is `if y < 0 then -(abs x) else abs x`
  $ hint fmod remainder rem quot even odd constrain clip lerp
  fmod: of Floats it is `x - y * floorFloat (x / y)`, which has the sign of y; of angles, `wrapAngle`
  remainder: of Floats it is `x - y * floorFloat (x / y)`, which has the sign of y; of angles, `wrapAngle`
  rem: `div` and `mod` of Ints round to minus infinity
  quot: `div` and `mod` of Ints round to minus infinity
  even: it is `mod n 2 == 0`
  odd: it is `mod n 2 == 1`
  constrain: it is `clamp low high x`: `import Control`
  clip: it is `clamp low high x`: `import Control`
  lerp: it is `a + t * (b - a)`
  $ hint isnan nan isinf isfinite NAN INFINITY
  isnan: NaN is the only number with `x /= x`; it is written `0 / 0`
  nan: NaN is the only number with `x /= x`; it is written `0 / 0`
  isinf: `x - x == 0` tells that x is finite; infinity is written `1 / 0`
  isfinite: `x - x == 0` tells that x is finite; infinity is written `1 / 0`
  NAN: NaN is written `0 / 0`
  INFINITY: infinity is written `1 / 0`
  $ hint PI M_PI TWO_PI HALF_PI deg2rad radians rad2deg degrees
  PI: it is `pi`
  M_PI: it is `pi`
  TWO_PI: it is `2 * pi`
  HALF_PI: it is `pi / 2`
  deg2rad: angles are in radians, and `90[deg]` is one; x degrees are `x * 1[deg]`
  radians: angles are in radians, and `90[deg]` is one; x degrees are `x * 1[deg]`
  rad2deg: an angle in degrees is `a / 1[deg]`
  degrees: an angle in degrees is `a / 1[deg]`
  $ hint wrapToPi normalize_angle shortest_angular_distance math.sqrt Math.sqrt np.abs random
  wrapToPi: it is `wrapAngle a`: `import Geometry`
  normalize_angle: it is `wrapAngle a`: `import Geometry`
  shortest_angular_distance: it is `angleDiff a b`: `import Geometry`
  math.sqrt: the functions on numbers need no module: `abs x`, `sqrt x`
  Math.sqrt: the functions on numbers need no module: `abs x`, `sqrt x`
  np.abs: the functions on numbers need no module: `abs x`, `sqrt x`
  random: noise that is the same in each run is `whiteNoise 1 ()`, of a seed: `import Sources`
  $ hint minimum maximum average len enumerate zeros append null TRUE
  minimum: the least element of an array is `minimumBy id xs`
  maximum: the greatest element of an array is `maximumBy id xs`
  average: it is `mean xs`
  len: the size of an array is `length xs`
  enumerate: `imap (\i x -> (i, x)) xs` has each element with its index
  zeros: `generate (const 0)` makes an array of as many elements as its type says
  append: an array keeps its size: `replace i x xs` has another element at i
  null: what may be missing is a `Maybe`: it is `Nothing`
  TRUE: it is `True`
  $ hint millis micros delayMicroseconds digitalWrite analogRead for undefined
  millis: `time ()` is the time since the start, in seconds
  micros: `time ()` is the time since the start, in seconds
  delayMicroseconds: a task that waits is `sleepT 2[s] restingOutput`, with the robot at rest
  digitalWrite: what is written is a part of the program's output
  analogRead: what is read is a part of the program's input
  for: `map f xs` is each element's; tasks one after the other are `forEachT xs f`
  undefined: a program never stops at a fault: what may have no value is a `Maybe`
  $ hint pre integrate deriv
  pre: it is `delay x0`
  integrate: it is `integral`
  deriv: it is `derivative`

A near name of the program's own or of the library is still offered where no other language has it:

  $ hint atan3 sqrtf constan
  atan3: did you mean `atan`?
  sqrtf: did you mean `sqrt`?
  constan: did you mean `constant`?

What the hints say is right:

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
