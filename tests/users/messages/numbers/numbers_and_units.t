Numbers and units in other notations.

  $ cat > point.frob <<'FROB'
  > x = .5
  > y = 5. + 2
  > FROB
  $ frobc check point.frob
  error[E0105]: the number `.5` has no digit before its decimal point
   --> point.frob:1:5
    |
  1 | x = .5
    |     ^^
    |
    = hint: write a digit before the decimal point: `0.5`
  
  error[E0105]: the number `5.` has no digit after its decimal point
   --> point.frob:2:5
    |
  2 | y = 5. + 2
    |     ^^
    |
    = hint: write a digit after the decimal point: `5.0`
  
  2 errors
  [1]

  $ cat > digits.frob <<'FROB'
  > n = 1_000_
  > k = 0xFG
  > b = 0b
  > f x = x ^ 9223372036854775807
  > FROB
  $ frobc check digits.frob
  error[E0105]: the number `1_000` is directly followed by `_`
   --> digits.frob:1:5
    |
  1 | n = 1_000_
    |     ^^^^^^
    |
    = hint: use `_` only between two digits
  
  error[E0105]: the number `0xF` is directly followed by `G`
   --> digits.frob:2:5
    |
  2 | k = 0xFG
    |     ^^^^
    |
    = hint: after `0x`, use the digits `0` to `9` and `a` to `f`
  
  error[E0105]: the number `0b` has no digits
   --> digits.frob:3:5
    |
  3 | b = 0b
    |     ^^
    |
    = hint: after `0b`, use the digits `0` and `1`
  
  error[E0117]: the exponent of `^` must be a literal whole number
   --> digits.frob:4:11
    |
  4 | f x = x ^ 9223372036854775807
    |           ^^^^^^^^^^^^^^^^^^^
    |
    = hint: for other exponents, use `**`, which takes Floats without a unit; for an Int `n`, write `x ** toFloat n`
  
  4 errors
  [1]

  $ cat > bits.frob <<'FROB'
  > mask :: Int
  > mask = 0xFFFF_0000
  > FROB
  $ frobc check bits.frob
  error[E0313]: `0xFFFF_0000` is out of range for an `Int`
   --> bits.frob:2:8
    |
  2 | mask = 0xFFFF_0000
    |        ^^^^^^^^^^^
    |
    = note: an `Int` must be between -2147483648 and 2147483647
    = hint: for these 32 bits, write `(-65536)`
  
  1 error
  [1]

A unit follows a literal or a type, never a name, without a space.

  $ cat > name.frob <<'FROB'
  > f :: Float -> Distance
  > f x = x[m]
  > FROB
  $ frobc check name.frob
  error[E0110]: a unit in brackets can follow a literal number or a type, but not a name
   --> name.frob:2:8
    |
  2 | f x = x[m]
    |        ^
    |
    = hint: remove the unit if the value already has one; to give a plain number a unit, multiply: `x * 1[m]`
  
  1 error
  [1]

  $ cat > blank.frob <<'FROB'
  > x = 5 [m]
  > FROB
  $ frobc check blank.frob
  error[E0110]: a unit must directly follow its number, without a space
   --> blank.frob:1:7
    |
  1 | x = 5 [m]
    |       ^^^
    |
    = hint: remove the space: `5[m]`
  
  1 error
  [1]

  $ cat > type.frob <<'FROB'
  > type Speed = m/s
  > FROB
  $ frobc check type.frob
  error[E0110]: expected `->` or the end of the type after a type variable, found `/`
   --> type.frob:1:15
    |
  1 | type Speed = m/s
    |               ^
    |
    = hint: start a type such as `Float` with a capital letter, and put a unit in brackets, as in `Float[m/s]`
  
  1 error
  [1]

A name in the size of an array is a type variable, not a number.

  $ cat > size.frob <<'FROB'
  > n = 4
  > xs :: Array n Float
  > xs = generate (\i -> toFloat i)
  > main :: SF Float Float
  > main = proc x -> x + xs ! 2
  > FROB
  $ frobc check size.frob
  error[E0331]: nothing determines the size of an array where `xs` is used
   --> size.frob:5:22
    |
  5 | main = proc x -> x + xs ! 2
    |                      ^^
    |
    = note: `n` in the signature of `xs` is a variable for any size: write a number instead, or name the size, as in `type Size = 4`
    = hint: add a type annotation, as in `(e :: Array 4 Float)`, or give the definition a signature
  
  1 error
  [1]

Degrees for an angle in radians have no other unit, but exceed a full turn. There is no warning for
a number with `rad` in its comment, or for a number that is not an angle.

  $ cat > degrees.frob <<'FROB'
  > import Geometry
  > start :: Pose
  > start = Pose { position = zeroVec, heading = -90 }
  > quarter :: Angle
  > quarter = 90
  > main :: SF Float Float
  > main = proc x -> cos 45 * x + cos quarter + start.heading + cos 90[rad] + cos 6.2 + exp 45
  > FROB
  $ frobc check degrees.frob
  warning[W0303]: this angle is in radians, so it is more than a whole turn
   --> degrees.frob:3:46
    |
  3 | start = Pose { position = zeroVec, heading = -90 }
    |                                              ^^^
    |
    = hint: if you meant degrees, write `(-90[deg])`
  
  warning[W0303]: this angle is in radians, so it is more than a whole turn
   --> degrees.frob:5:11
    |
  5 | quarter = 90
    |           ^^
    |
    = hint: if you meant degrees, write `90[deg]`
  
  warning[W0303]: this angle is in radians, so it is more than a whole turn
   --> degrees.frob:7:22
    |
  7 | main = proc x -> cos 45 * x + cos quarter + start.heading + cos 90[rad] + cos 6.2 + exp 45
    |                      ^^
    |
    = hint: if you meant degrees, write `45[deg]`
  
  3 warnings

The same for a number that is added to an angle, and for a product of numbers; a number next to a
signal may be a frequency.

  $ cat > sums.frob <<'FROB'
  > import Geometry
  > back :: Pose -> Angle -> Angle
  > back p a = wrapAngle (p.heading - 180 + a)
  > right :: Angle -> Angle
  > right a = a + 2 * 45
  > wave :: Float -> Angle -> Float
  > wave t a = sin (100 * t) + cos (-(90 / 1)) + sin (7 / 2 + t) + cos (a + 90[deg]) + tan (t - 4 - 5)
  > main :: SF Float Float
  > main = proc x -> wave x x + right x + back (Pose { position = zeroVec, heading = x }) x
  > FROB
  $ frobc check sums.frob
  warning[W0303]: this angle is in radians, so it is more than a whole turn
   --> sums.frob:3:35
    |
  3 | back p a = wrapAngle (p.heading - 180 + a)
    |                                   ^^^
    |
    = hint: if you meant degrees, write `180[deg]`
  
  warning[W0303]: this angle is in radians, so it is more than a whole turn
   --> sums.frob:5:15
    |
  5 | right a = a + 2 * 45
    |               ^^^^^^
    |
    = hint: if you meant degrees, give one of the numbers its unit, as in `90[deg]`
  
  warning[W0303]: this angle is in radians, so it is more than a whole turn
   --> sums.frob:7:33
    |
  7 | wave t a = sin (100 * t) + cos (-(90 / 1)) + sin (7 / 2 + t) + cos (a + 90[deg]) + tan (t - 4 - 5)
    |                                 ^^^^^^^^^
    |
    = hint: if you meant degrees, give one of the numbers its unit, as in `90[deg]`
  
  3 warnings

Degrees that are compared with an angle, on either side, also if an expression is an angle because
of its operand.

  $ cat > compared.frob <<'FROB'
  > import Geometry
  > main :: SF (Pose, Float[m]) (Bool, Bool, Bool, Bool, Bool)
  > main = proc (pose, x) -> (h > 90, -45 <= h, abs (angleDiff h 0) > 2 * 45, h + pose.heading == 180, x > 90[m] || h > 3) where
  >     h = pose.heading
  > FROB
  $ frobc check compared.frob
  warning[W0303]: this angle is in radians, so it is more than a whole turn
   --> compared.frob:3:31
    |
  3 | main = proc (pose, x) -> (h > 90, -45 <= h, abs (angleDiff h 0) > 2 * 45, h + pose.heading == 180, x > 90[m] || h > 3) w…
    |                               ^^
    |
    = hint: if you meant degrees, write `90[deg]`
  
  warning[W0303]: this angle is in radians, so it is more than a whole turn
   --> compared.frob:3:35
    |
  3 | main = proc (pose, x) -> (h > 90, -45 <= h, abs (angleDiff h 0) > 2 * 45, h + pose.heading == 180, x > 90[m] || h > 3) w…
    |                                   ^^^
    |
    = hint: if you meant degrees, write `(-45[deg])`
  
  warning[W0303]: this angle is in radians, so it is more than a whole turn
   --> compared.frob:3:67
    |
  3 | …h > 90, -45 <= h, abs (angleDiff h 0) > 2 * 45, h + pose.heading == 180, x > 90[m] || h > 3) where
    |                                          ^^^^^^
    |
    = hint: if you meant degrees, give one of the numbers its unit, as in `90[deg]`
  
  warning[W0303]: this angle is in radians, so it is more than a whole turn
   --> compared.frob:3:95
    |
  3 | …Diff h 0) > 2 * 45, h + pose.heading == 180, x > 90[m] || h > 3) where
    |                                          ^^^
    |
    = hint: if you meant degrees, write `180[deg]`
  
  4 warnings
