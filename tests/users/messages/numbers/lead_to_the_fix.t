Mistakes of newcomers with types and units. Every replacement that a message offers compiles when
it is pasted.

A number without a unit, as an argument next to a quantity:

  $ cat > least.frob <<'FROB'
  > f :: SF Velocity Velocity
  > f = proc v -> min 0.3 v
  > FROB
  $ frobc check least.frob
  error[E0320]: expected the unit `m/s`, found none
   --> least.frob:2:19
    |
  2 | f = proc v -> min 0.3 v
    |                   ^^^ - because this is `Velocity` (m/s), and `min` needs matching units
    |                   |
    |                   argument 1 of `min`
    |
    = hint: write `0.3[m/s]` if that is the right unit
  
  1 error
  [1]
  $ sed 's:0.3:0.3[m/s]:' least.frob > pasted.frob && frobc check pasted.frob

The function relates the units of its arguments, and the number is the mistake:

  $ cat > limit.frob <<'FROB'
  > import Control
  > f :: SF Distance AngularVelocity
  > f = proc e -> limit 1 (4[rad/(m s)] * e)
  > FROB
  $ frobc check limit.frob
  error[E0320]: expected the unit `1/s`, found none
   --> limit.frob:3:21
    |
  3 | f = proc e -> limit 1 (4[rad/(m s)] * e)
    |                     ^  ---------------- because this is `Float[1/s]`, and `limit` needs matching units
    |                     |
    |                     argument 1 of `limit`
    |
    = hint: write `1[1/s]` if that is the right unit
  
  1 error
  [1]
  $ sed 's:limit 1 :limit 1[1/s] :' limit.frob > pasted.frob && frobc check pasted.frob



  $ cat > rate.frob <<'FROB'
  > import Control
  > f :: SF Velocity Velocity
  > f = proc v -> rateLimit 0.3[m/s] v
  > FROB
  $ frobc check rate.frob
  error[E0320]: expected the unit `m/s^2`, found `m/s`
   --> rate.frob:3:25
    |
  3 | f = proc v -> rateLimit 0.3[m/s] v
    |                         ^^^^^^^^ - because this is `Velocity` (m/s), and `rateLimit` needs matching units
    |                         |
    |                         argument 1 of `rateLimit`
    |
    = hint: write `0.3[m/s^2]` if you meant that unit
  
  1 error
  [1]
  $ sed 's:0.3\[m/s\]:0.3[m/s^2]:' rate.frob > pasted.frob && frobc check pasted.frob

Two numbers without a unit, one of them negative; zero has any unit:

  $ cat > clamp.frob <<'FROB'
  > import Control
  > f, g :: SF Velocity Velocity
  > f = proc v -> clamp (-1) 1 v
  > g = proc v -> clamp 0 1 v
  > FROB
  $ frobc check clamp.frob
  error[E0320]: expected the unit `m/s`, found none
   --> clamp.frob:3:22
    |
  3 | f = proc v -> clamp (-1) 1 v
    |                      ^^    - because this is `Velocity` (m/s), and `clamp` needs matching units
    |                      |
    |                      argument 1 of `clamp`
    |
    = hint: write `-1[m/s]` and `1[m/s]` if these are the right units
  
  error[E0320]: expected the unit `m/s`, found none
   --> clamp.frob:4:23
    |
  4 | g = proc v -> clamp 0 1 v
    |                       ^ - because this is `Velocity` (m/s), and `clamp` needs matching units
    |                       |
    |                       argument 2 of `clamp`
    |
    = hint: write `1[m/s]` if that is the right unit
  
  2 errors
  [1]
  $ sed 's:(-1) 1 v:(-1[m/s]) 1[m/s] v:; s:0 1 v:0 1[m/s] v:' clamp.frob > pasted.frob && frobc check pasted.frob

An initial value without the unit of the event:

  $ cat > held.frob <<'FROB'
  > f :: SF (Event (), Velocity) Velocity
  > f = proc (e, v) -> hold 0.5 (tag e v)
  > FROB
  $ frobc check held.frob
  error[E0320]: expected the unit `m/s`, found none
   --> held.frob:2:25
    |
  2 | f = proc (e, v) -> hold 0.5 (tag e v)
    |                         ^^^  ------- because this is `Event Velocity`, and `hold` needs matching units
    |                         |
    |                         argument 1 of `hold`
    |
    = hint: write `0.5[m/s]` if that is the right unit
  
  1 error
  [1]
  $ sed 's:0.5:0.5[m/s]:' held.frob > pasted.frob && frobc check pasted.frob

A constant that lacks its unit, far from the place where the unit is needed:

  $ cat > constant.frob <<'FROB'
  > import Robot
  > kp = 0.8
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = kp * (frontSonar i - 0.5[m]))
  > FROB
  $ frobc check constant.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> constant.frob:3:52
    |
  2 | kp = 0.8
    |      --- `kp` is defined as this number, which has no unit
  3 | main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
    |                                           -------- ^ this is `Float[m]`
    |                                           |
    |                                           argument 1 of `setVelTR` is `Velocity` (m/s)
    |
    = hint: give `kp` its unit: `kp = 0.8[1/s]`
  
  1 error
  [1]
  $ sed 's:kp = 0.8:kp = 0.8[1/s]:' constant.frob > pasted.frob && frobc check pasted.frob



  $ cat > divisor.frob <<'FROB'
  > tau = 2.0
  > f :: SF Distance Velocity
  > f = proc d -> d / tau
  > FROB
  $ frobc check divisor.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> divisor.frob:3:15
    |
  1 | tau = 2.0
    |       --- `tau` is defined as this number, which has no unit
  2 | f :: SF Distance Velocity
    |      -------------------- the signature of `f` requires the output `Velocity` (m/s)
  3 | f = proc d -> d / tau
    |               ^^^^^^^ this is `Float[m]`
    |
    = hint: give `tau` its unit: `tau = 2.0[s]`
  
  1 error
  [1]
  $ sed 's:tau = 2.0:tau = 2.0[s]:' divisor.frob > pasted.frob && frobc check pasted.frob



  $ cat > threshold.frob <<'FROB'
  > near = 0.5
  > f :: SF Distance Bool
  > f = proc d -> d < near
  > FROB
  $ frobc check threshold.frob
  error[E0320]: the operands of `<` have different units: `m` and `1`
   --> threshold.frob:3:19
    |
  1 | near = 0.5
    |        --- `near` is defined as this number, which has no unit
  2 | f :: SF Distance Bool
  3 | f = proc d -> d < near
    |               -   ^^^^ this is `Float`
    |               |
    |               this is `Distance` (m)
    |
    = hint: give `near` its unit: `near = 0.5[m]`
  
  1 error
  [1]
  $ sed 's:near = 0.5:near = 0.5[m]:' threshold.frob > pasted.frob && frobc check pasted.frob

A constant with a signature:

  $ cat > signed.frob <<'FROB'
  > kp :: Float
  > kp = 0.8
  > f :: SF Distance Velocity
  > f = proc d -> kp * d
  > FROB
  $ frobc check signed.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> signed.frob:4:15
    |
  2 | kp = 0.8
    |      --- `kp` is defined as this number, which has no unit
  3 | f :: SF Distance Velocity
    |      -------------------- the signature of `f` requires the output `Velocity` (m/s)
  4 | f = proc d -> kp * d
    |               ^^^^^^ this is `Float[m]`
    |
    = hint: give `kp` its unit: `kp :: Float[1/s]` and `kp = 0.8[1/s]`
  
  1 error
  [1]
  $ sed 's:kp \:\: Float:kp \:\: Float[1/s]:; s:kp = 0.8:kp = 0.8[1/s]:' signed.frob > pasted.frob && frobc check pasted.frob

A parameter:

  $ cat > parameter.frob <<'FROB'
  > param kp :: Float = 0.8
  > f :: SF Distance Velocity
  > f = proc d -> kp * d
  > FROB
  $ frobc check parameter.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> parameter.frob:3:15
    |
  1 | param kp :: Float = 0.8
    |                     --- `kp` is defined as this number, which has no unit
  2 | f :: SF Distance Velocity
    |      -------------------- the signature of `f` requires the output `Velocity` (m/s)
  3 | f = proc d -> kp * d
    |               ^^^^^^ this is `Float[m]`
    |
    = hint: give `kp` its unit: `param kp :: Float[1/s] = 0.8[1/s]`
  
  1 error
  [1]
  $ sed 's:^param.*:param kp \:\: Float[1/s] = 0.8[1/s]:' parameter.frob > pasted.frob && frobc check pasted.frob

A frequency as an angle:

  $ cat > sine.frob <<'FROB'
  > freq = 2[Hz]
  > f :: SF () Float
  > f = proc _ -> sin(2*pi*freq)
  > FROB
  $ frobc check sine.frob
  error[E0320]: expected no unit, found `1/s`
   --> sine.frob:3:19
    |
  3 | f = proc _ -> sin(2*pi*freq)
    |               --- ^^^^^^^^^ this is `Float[1/s]`
    |               |
    |               argument 1 of `sin` is `Angle` (1)
    |
    = hint: an angle is a rate times a time: in a `proc`, write `sin (2*pi*freq * time ())`
  
  1 error
  [1]
  $ sed 's:sin(2\*pi\*freq):sin (2*pi*freq * time ()):' sine.frob > pasted.frob && frobc check pasted.frob

A frequency that changes:

  $ cat > phase.frob <<'FROB'
  > f :: SF AngularVelocity Float
  > f = proc w -> cos w
  > FROB
  $ frobc check phase.frob
  error[E0320]: expected no unit, found `1/s`
   --> phase.frob:2:19
    |
  2 | f = proc w -> cos w
    |               --- ^ this is `AngularVelocity` (1/s)
    |               |
    |               argument 1 of `cos` is `Angle` (1)
    |
    = hint: an angle is a rate times a time: in a `proc`, write `cos (integral w)`
  
  1 error
  [1]
  $ sed 's:cos w:cos (integral w):' phase.frob > pasted.frob && frobc check pasted.frob

A power of a quantity:

  $ cat > power.frob <<'FROB'
  > f :: SF (Distance, Distance) Distance
  > f = proc (x, y) -> sqrt (x ** 2 + y ** 2.0)
  > FROB
  $ frobc check power.frob
  error[E0320]: expected no unit, found `m`
   --> power.frob:2:26
    |
  2 | f = proc (x, y) -> sqrt (x ** 2 + y ** 2.0)
    |                          ^ -- argument 1 of `**` is `Float`
    |                          |
    |                          this is `Distance` (m)
    |
    = hint: for a power with an integer exponent, write `x ^ 2`
  
  error[E0320]: expected no unit, found `m`
   --> power.frob:2:35
    |
  2 | f = proc (x, y) -> sqrt (x ** 2 + y ** 2.0)
    |                                   ^ -- argument 1 of `**` is `Float`
    |                                   |
    |                                   this is `Distance` (m)
    |
    = hint: for a power with an integer exponent, write `y ^ 2`
  
  2 errors
  [1]
  $ sed 's:x \*\* 2 + y \*\* 2.0:x ^ 2 + y ^ 2:' power.frob > pasted.frob && frobc check pasted.frob



  $ cat > root.frob <<'FROB'
  > f :: SF Float[m^2] Distance
  > f = proc a -> a ** 0.5
  > FROB
  $ frobc check root.frob
  error[E0320]: expected no unit, found `m^2`
   --> root.frob:2:15
    |
  2 | f = proc a -> a ** 0.5
    |               ^ -- argument 1 of `**` is `Float`
    |               |
    |               this is `Float[m^2]`
    |
    = hint: for a square root, write `sqrt a`
  
  1 error
  [1]
  $ sed 's:a \*\* 0.5:sqrt a:' root.frob > pasted.frob && frobc check pasted.frob

The remainder of an angle, and of a distance:

  $ cat > modulus.frob <<'FROB'
  > f :: SF Angle Angle
  > f = proc a -> mod a (2 * pi)
  > FROB
  $ frobc check modulus.frob
  error[E0312]: expected `Int`, found `Angle` (1)
   --> modulus.frob:2:19
    |
  2 | f = proc a -> mod a (2 * pi)
    |               --- ^
    |               |
    |               argument 1 of `mod` is `Int`
    |
    = hint: `mod` is for whole numbers: for an angle between -pi and pi, write `wrapAngle a`, with `import Geometry`; for an angle that is never negative, write `a - (2 * pi) * floorFloat (a / (2 * pi))`
  
  1 error
  [1]
  $ sed 's:mod a (2 \* pi):wrapAngle a:; 1s:^:import Geometry\n:' modulus.frob > pasted.frob && frobc check pasted.frob



  $ cat > remainder.frob <<'FROB'
  > f :: SF Distance Distance
  > f = proc d -> d `mod` 1[m]
  > FROB
  $ frobc check remainder.frob
  error[E0312]: expected `Int`, found `Distance` (m)
   --> remainder.frob:2:15
    |
  2 | f = proc d -> d `mod` 1[m]
    |               ^ ----- argument 1 of `mod` is `Int`
    |
    = hint: `mod` is for whole numbers: for the remainder, write `d - 1[m] * floorFloat (d / 1[m])`
  
  1 error
  [1]
  $ sed 's:d `mod` 1\[m\]:d - 1[m] * floorFloat (d / 1[m]):' remainder.frob > pasted.frob && frobc check pasted.frob

Half of a whole number:

  $ cat > half.frob <<'FROB'
  > f :: SF Int Int
  > f = proc n -> n / 2
  > FROB
  $ frobc check half.frob
  error[E0312]: expected `Float`, found `Int`
   --> half.frob:2:15
    |
  2 | f = proc n -> n / 2
    |               ^ - argument 1 of `/` is `Float`
    |
    = hint: for a whole number, write `div n 2`, which rounds down; for a number with a fraction, write `toFloat n / 2`
  
  1 error
  [1]
  $ sed 's:n / 2:div n 2:' half.frob > pasted.frob && frobc check pasted.frob
  $ sed 's:n / 2:toFloat n / 2:; s:SF Int Int:SF Int Float:' half.frob > pasted.frob && frobc check pasted.frob

A consistent definition, and a signature that does not match it:

  $ cat > against_signature.frob <<'FROB'
  > f :: SF Velocity Velocity
  > f = proc v -> integral v
  > FROB
  $ frobc check against_signature.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> against_signature.frob:2:15
    |
  1 | f :: SF Velocity Velocity
    |      -------------------- the signature of `f` requires the output `Velocity` (m/s)
  2 | f = proc v -> integral v
    |               ^^^^^^^^^^ this is `Float[m]`
    |
    = hint: remove `integral`: `v` is already in `m/s`
    = hint: if this is the right result, write the signature as `f :: SF Velocity Float[m]`
  
  1 error
  [1]
  $ sed 's:SF Velocity Velocity:SF Velocity Float[m]:' against_signature.frob > pasted.frob && frobc check pasted.frob



  $ cat > root_of_a_distance.frob <<'FROB'
  > f :: SF Distance Distance
  > f = proc d -> sqrt d
  > FROB
  $ frobc check root_of_a_distance.frob
  error[E0320]: expected the unit `m`, found `m^(1/2)`
   --> root_of_a_distance.frob:2:15
    |
  1 | f :: SF Distance Distance
    |      -------------------- the signature of `f` requires the output `Distance` (m)
  2 | f = proc d -> sqrt d
    |               ^^^^^^ this is `Float[m^(1/2)]`
    |
    = note: `sqrt` halves the exponents of the unit: for `m`, its argument must be in `m^2`
    = hint: to take the root of the number alone, write `sqrt (d / 1[m]) * 1[m]`
  
  1 error
  [1]
  $ sed 's:sqrt d:sqrt (d / 1[m]) * 1[m]:' root_of_a_distance.frob > pasted.frob && frobc check pasted.frob

A number in a formula that lacks its unit:

  $ cat > inline_gain.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.3[m/s] w) where
  >     w = 0.5 * (sideSonar i - 0.4[m]))
  > FROB
  $ frobc check inline_gain.frob
  error[E0320]: expected the unit `1/s`, found `m`
   --> inline_gain.frob:2:61
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR 0.3[m/s] w) where
    |                                           --------          ^ this is `Float[m]`
    |                                           |
    |                                           argument 2 of `setVelTR` is `AngularVelocity` (1/s)
  3 |     w = 0.5 * (sideSonar i - 0.4[m]))
    |         --- this factor has no unit
    |
    = hint: if the factor `0.5` has a unit, write it: `0.5[1/m/s]`
  
  1 error
  [1]
  $ sed 's:0.5:0.5[1/m/s]:' inline_gain.frob > pasted.frob && frobc check pasted.frob



  $ cat > inline_divisor.frob <<'FROB'
  > f :: SF (Velocity, Velocity) AngularVelocity
  > f = proc (l, r) -> (r - l) / 0.3
  > FROB
  $ frobc check inline_divisor.frob
  error[E0320]: expected the unit `1/s`, found `m/s`
   --> inline_divisor.frob:2:20
    |
  1 | f :: SF (Velocity, Velocity) AngularVelocity
    |      --------------------------------------- the signature of `f` requires the output `AngularVelocity` (1/s)
  2 | f = proc (l, r) -> (r - l) / 0.3
    |                    ^^^^^^^^^^^^^ this is `Float[m/s]`
    |
    = hint: if the divisor `0.3` has a unit, write it: `0.3[m]`
    = hint: if this is the right result, write the signature as `f :: SF (Velocity, Velocity) Float[m/s]`
  
  1 error
  [1]
  $ sed 's:0.3:0.3[m]:' inline_divisor.frob > pasted.frob && frobc check pasted.frob

A superfluous unit:

  $ cat > mean.frob <<'FROB'
  > f :: SF (Array 4 Distance) Distance
  > f = proc ds -> sum ds / 4[m]
  > FROB
  $ frobc check mean.frob
  error[E0320]: expected the unit `m`, found none
   --> mean.frob:2:16
    |
  1 | f :: SF (Array 4 Distance) Distance
    |      ------------------------------ the signature of `f` requires the output `Distance` (m)
  2 | f = proc ds -> sum ds / 4[m]
    |                ^^^^^^^^^^^^^ this is `Float`
    |
    = hint: write `4`, without a unit, if it is a plain number
  
  1 error
  [1]
  $ sed 's:4\[m\]:4:' mean.frob > pasted.frob && frobc check pasted.frob

A constant that lacks its unit, in an operand:

  $ cat > track.frob <<'FROB'
  > f :: SF (Velocity, AngularVelocity) (Velocity, Velocity)
  > f = proc (v, w) -> (v - w * l / 2, v + w * l / 2) where
  >     l = 0.3
  > FROB
  $ frobc check track.frob
  error[E0320]: the operands of `-` have different units: `m/s` and `1/s`
   --> track.frob:2:25
    |
  2 | f = proc (v, w) -> (v - w * l / 2, v + w * l / 2) where
    |                     -   ^^^^^^^^^ this is `Float[1/s]`
    |                     |
    |                     this is `Velocity` (m/s)
  3 |     l = 0.3
    |         --- `l` is defined as this number, which has no unit
    |
    = hint: give `l` its unit: `l = 0.3[m]`
  
  error[E0320]: the operands of `+` have different units: `m/s` and `1/s`
   --> track.frob:2:40
    |
  2 | f = proc (v, w) -> (v - w * l / 2, v + w * l / 2) where
    |                                    -   ^^^^^^^^^ this is `Float[1/s]`
    |                                    |
    |                                    this is `Velocity` (m/s)
  3 |     l = 0.3
    |         --- `l` is defined as this number, which has no unit
    |
    = hint: give `l` its unit: `l = 0.3[m]`
  
  2 errors
  [1]
  $ sed 's:l = 0.3:l = 0.3[m]:' track.frob > pasted.frob && frobc check pasted.frob

A number in a function that is an argument:

  $ cat > section.frob <<'FROB'
  > f :: SF (Array 4 Distance) Bool
  > f = proc ds -> any (< 0.5) ds
  > FROB
  $ frobc check section.frob
  error[E0320]: expected the unit `m`, found none
   --> section.frob:2:23
    |
  2 | f = proc ds -> any (< 0.5) ds
    |                       ^^^  -- because this is `Array 4 Distance`, and `any` needs matching units
    |                       |
    |                       argument 1 of `any`
    |
    = hint: write `0.5[m]` if that is the right unit
  
  1 error
  [1]
  $ sed 's:0.5:0.5[m]:' section.frob > pasted.frob && frobc check pasted.frob



  $ cat > fold.frob <<'FROB'
  > f :: SF (Array 4 Distance) Distance
  > f = proc ds -> foldl min 10 ds
  > FROB
  $ frobc check fold.frob
  error[E0320]: expected the unit `m`, found none
   --> fold.frob:2:26
    |
  2 | f = proc ds -> foldl min 10 ds
    |                          ^^ -- because this is `Array 4 Distance`, and `foldl` needs matching units
    |                          |
    |                          argument 2 of `foldl`
    |
    = hint: write `10[m]` if that is the right unit
  
  1 error
  [1]
  $ sed 's:10:10[m]:' fold.frob > pasted.frob && frobc check pasted.frob

A vector of plain numbers:

  $ cat > goal.frob <<'FROB'
  > import Geometry
  > goal = Vec2 { x = 1, y = -2 }
  > f :: SF Point2 Distance
  > f = proc p -> norm (goal ^-^ p)
  > FROB
  $ frobc check goal.frob
  error[E0320]: the operands of `^-^` have different units: `1` and `m`
   --> goal.frob:4:30
    |
  2 | goal = Vec2 { x = 1, y = -2 }
    |                   - this number has no unit
  3 | f :: SF Point2 Distance
  4 | f = proc p -> norm (goal ^-^ p)
    |                     ----     ^ this is `Point2`
    |                     |
    |                     this is `Vec2[1]`
    |
    = note: expected `Vec2[1]`, found `Point2`
    = hint: give the fields their unit: `x = 1[m], y = -2[m]`
  
  1 error
  [1]
  $ sed 's:x = 1, y = -2:x = 1[m], y = -2[m]:' goal.frob > pasted.frob && frobc check pasted.frob

A sum that should be a product:

  $ cat > sum.frob <<'FROB'
  > f :: SF (Velocity, Time) Distance
  > f = proc (v, t) -> v + t
  > FROB
  $ frobc check sum.frob
  error[E0320]: the operands of `+` have different units: `m/s` and `s`
   --> sum.frob:2:24
    |
  2 | f = proc (v, t) -> v + t
    |                    -   ^ this is `Time` (s)
    |                    |
    |                    this is `Velocity` (m/s)
    |
    = hint: the operands of `+` must have the same unit: if you meant the product, write `v * t`, which is in `m`
  
  1 error
  [1]
  $ sed 's:v + t:v * t:' sum.frob > pasted.frob && frobc check pasted.frob

A difference that should be a rate:

  $ cat > difference.frob <<'FROB'
  > f :: SF Distance Velocity
  > f = proc d -> d - delay 0 d
  > FROB
  $ frobc check difference.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> difference.frob:2:15
    |
  1 | f :: SF Distance Velocity
    |      -------------------- the signature of `f` requires the output `Velocity` (m/s)
  2 | f = proc d -> d - delay 0 d
    |               ^^^^^^^^^^^^^ this is `Float[m]`
    |
    = hint: for the rate of change, write `derivative d`, which divides the difference by the length of the step
  
  1 error
  [1]
  $ sed 's:d - delay 0 d:derivative d:' difference.frob > pasted.frob && frobc check pasted.frob

A plain number as a quantity:

  $ cat > plain.frob <<'FROB'
  > f :: SF Float Distance
  > f = proc x -> x
  > FROB
  $ frobc check plain.frob
  error[E0320]: expected the unit `m`, found none
   --> plain.frob:2:15
    |
  1 | f :: SF Float Distance
    |      ----------------- the signature of `f` requires the output `Distance` (m)
  2 | f = proc x -> x
    |               ^ this is `Float`
    |
    = hint: if the number is in `m`, multiply by the unit: `x * 1[m]`
  
  1 error
  [1]
  $ sed 's:-> x:-> x * 1[m]:' plain.frob > pasted.frob && frobc check pasted.frob

Numbers in place of a record of gains:

  $ cat > gains.frob <<'FROB'
  > import Control
  > f :: SF Distance Velocity
  > f = pid 1 0.1 0.01
  > FROB
  $ frobc check gains.frob
  error[E0301]: expected `Pid[u, v]`, found a number
   --> gains.frob:3:9
    |
  3 | f = pid 1 0.1 0.01
    |     --- ^
    |     |
    |     argument 1 of `pid` is `Pid[u, v]`
    |
    = hint: `pid` takes a single record, not separate numbers: write `pid (Pid { kp = 1, ki = 0.1, kd = 0.01, largest = … })`
  
  1 error
  [1]
  $ sed 's|pid 1 0.1 0.01|pid (Pid { kp = 1[1/s], ki = 0.1[1/s^2], kd = 0.01, largest = 1[m/s] })|' gains.frob > pasted.frob && frobc check pasted.frob

A truth value as a number:

  $ cat > truth.frob <<'FROB'
  > f :: SF Bool Float
  > f = proc b -> b * 2
  > FROB
  $ frobc check truth.frob
  error[E0301]: expected a number, found `Bool`
   --> truth.frob:2:15
    |
  2 | f = proc b -> b * 2
    |               ^ - argument 1 of `*` is a number
    |
    = hint: a `Bool` is not a number: write `(if b then 1 else 0)`
  
  1 error
  [1]
  $ sed 's:-> b:-> (if b then 1 else 0):' truth.frob > pasted.frob && frobc check pasted.frob



  $ cat > delayed_truth.frob <<'FROB'
  > f :: SF Bool Bool
  > f = proc b -> x where
  >     x = delay 0 b
  > FROB
  $ frobc check delayed_truth.frob
  error[E0301]: expected a number, found `Bool`
   --> delayed_truth.frob:3:17
    |
  3 |     x = delay 0 b
    |         ----- - ^
    |         |     |
    |         |     because this is a number
    |         argument 2 of `delay` is a number
    |
    = hint: `0` is not a `Bool`: write `delay False b`
  
  1 error
  [1]
  $ sed 's:delay 0 b:delay False b:' delayed_truth.frob > pasted.frob && frobc check pasted.frob

A value that may be missing:

  $ cat > missing_value.frob <<'FROB'
  > f :: SF (Maybe Int) Bool
  > f = proc m -> m > 3
  > FROB
  $ frobc check missing_value.frob
  error[E0301]: expected a number, found `Maybe Int`
   --> missing_value.frob:2:15
    |
  2 | f = proc m -> m > 3
    |               ^   - this is a number
    |
    = hint: use `fromMaybe 0 m`, where `0` replaces a missing value
  
  1 error
  [1]
  $ sed 's:m >:fromMaybe 0 m >:' missing_value.frob > pasted.frob && frobc check pasted.frob

A vector as two numbers, and a field of a result:

  $ cat > direction.frob <<'FROB'
  > import Geometry
  > f :: SF Point2 Angle
  > f = proc p -> atan2 p
  > FROB
  $ frobc check direction.frob
  error[E0301]: expected `Float[u]`, found `Point2`
   --> direction.frob:3:21
    |
  3 | f = proc p -> atan2 p
    |               ----- ^
    |               |
    |               argument 1 of `atan2` is `Float[u]`
    |
    = hint: for the direction of a vector, write `direction p`, with `import Geometry`
  
  1 error
  [1]
  $ sed 's:atan2 p:direction p:' direction.frob > pasted.frob && frobc check pasted.frob



  $ cat > field.frob <<'FROB'
  > import Robot
  > f :: SF RobotInput Distance
  > f = proc i -> robotPose i.x
  > FROB
  $ frobc check field.frob
  error[E0310]: `PioneerInput` has no field `x`
   --> field.frob:3:27
    |
  3 | f = proc i -> robotPose i.x
    |                         - ^
    |                         |
    |                         this is `PioneerInput`
    |
    = hint: field access binds tighter than function application: write `(robotPose i).position.x`
  
  1 error
  [1]
  $ sed 's:robotPose i.x:(robotPose i).position.x:' field.frob > pasted.frob && frobc check pasted.frob

The sum of a signal, and of an array:

  $ cat > sum_over_time.frob <<'FROB'
  > f :: SF Velocity Distance
  > f = proc v -> sum v
  > FROB
  $ frobc check sum_over_time.frob
  error[E0301]: expected `Array m n[u]`, found `Velocity` (m/s)
   --> sum_over_time.frob:2:19
    |
  2 | f = proc v -> sum v
    |               --- ^
    |               |
    |               argument 1 of `sum` is `Array m n[u]`
    |
    = hint: `sum` adds the elements of an array: for the sum of a signal over time, write `integral v`
  
  1 error
  [1]
  $ sed 's:sum v:integral v:' sum_over_time.frob > pasted.frob && frobc check pasted.frob



  $ cat > mean_of_an_array.frob <<'FROB'
  > f :: SF (Array 3 Float) Float
  > f = proc xs -> sum xs / length xs
  > FROB
  $ frobc check mean_of_an_array.frob
  error[E0312]: the operands of `/` are `Float` and `Int`
   --> mean_of_an_array.frob:2:25
    |
  2 | f = proc xs -> sum xs / length xs
    |                ------   ^^^^^^^^^ this is `Int`
    |                |
    |                this is `Float`
    |
    = hint: write `toFloat (length xs)`
  
  1 error
  [1]
  $ sed 's:length xs:toFloat (length xs):' mean_of_an_array.frob > pasted.frob && frobc check pasted.frob

A product that should be a quotient:

  $ cat > quotient.frob <<'FROB'
  > f :: SF (Velocity, Distance) AngularVelocity
  > f = proc (v, r) -> v * r
  > FROB
  $ frobc check quotient.frob
  error[E0320]: expected the unit `1/s`, found `m^2/s`
   --> quotient.frob:2:20
    |
  1 | f :: SF (Velocity, Distance) AngularVelocity
    |      --------------------------------------- the signature of `f` requires the output `AngularVelocity` (1/s)
  2 | f = proc (v, r) -> v * r
    |                    ^^^^^ this is `Float[m^2/s]`
    |
    = hint: write `v / r`, which has the expected unit
  
  1 error
  [1]
  $ sed 's:v \* r:v / r:' quotient.frob > pasted.frob && frobc check pasted.frob

An angle for a turn rate, a turn rate for an angle, and a unit for a plain number:

  $ cat > angles.frob <<'FROB'
  > import Control
  > f :: SF AngularVelocity AngularVelocity
  > f = proc w -> limit 30[deg] w
  > g :: SF Angle Angle
  > g = proc a -> limit 20[deg/s] a
  > h :: SF Float Float
  > h = proc x -> limit 1[m/s] x
  > FROB
  $ frobc check angles.frob
  error[E0320]: expected the unit `1/s`, found none
   --> angles.frob:3:21
    |
  3 | f = proc w -> limit 30[deg] w
    |                     ^^^^^^^ - because this is `AngularVelocity` (1/s), and `limit` needs matching units
    |                     |
    |                     argument 1 of `limit`
    |
    = hint: write `30[deg/s]` if you meant that unit
  
  error[E0320]: expected no unit, found `1/s`
   --> angles.frob:5:21
    |
  5 | g = proc a -> limit 20[deg/s] a
    |                     ^^^^^^^^^ - because this is `Angle` (1), and `limit` needs matching units
    |                     |
    |                     argument 1 of `limit`
    |
    = hint: write `20[deg]` if you meant that unit
  
  error[E0320]: expected no unit, found `m/s`
   --> angles.frob:7:21
    |
  7 | h = proc x -> limit 1[m/s] x
    |                     ^^^^^^ - because this is `Float`, and `limit` needs matching units
    |                     |
    |                     argument 1 of `limit`
    |
    = hint: write `1`, without a unit
  
  3 errors
  [1]
  $ sed 's:30\[deg\]:30[deg/s]:; s:20\[deg/s\]:20[deg]:; s:1\[m/s\]:1:' angles.frob > pasted.frob && frobc check pasted.frob

A constant with another unit, and the first of two numbers:

  $ cat > fastest.frob <<'FROB'
  > import Control
  > fastest = 0.4[m]
  > f, g :: SF Velocity Velocity
  > f = proc v -> limit fastest v
  > g = proc v -> clamp 0.1[s] 0.5[m/s] v
  > FROB
  $ frobc check fastest.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> fastest.frob:4:21
    |
  2 | fastest = 0.4[m]
    |           ------ `fastest` is defined as this number
  3 | f, g :: SF Velocity Velocity
  4 | f = proc v -> limit fastest v
    |                     ^^^^^^^ - because this is `Velocity` (m/s), and `limit` needs matching units
    |                     |
    |                     argument 1 of `limit`
    |
    = hint: if `fastest` has the wrong unit, write `fastest = 0.4[m/s]`
  
  error[E0320]: expected the unit `m/s`, found `s`
   --> fastest.frob:5:21
    |
  5 | g = proc v -> clamp 0.1[s] 0.5[m/s] v
    |                     ^^^^^^ -------- because this is `Float[m/s]`, and `clamp` needs matching units
    |                     |
    |                     argument 1 of `clamp`
    |
    = hint: write `0.1[m/s]` if you meant that unit
  
  2 errors
  [1]
  $ sed 's:0.4\[m\]:0.4[m/s]:; s:0.1\[s\]:0.1[m/s]:' fastest.frob > pasted.frob && frobc check pasted.frob
