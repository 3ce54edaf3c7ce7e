Formulas where one small change gives the right unit, and gains in sums. Each program has one
faulty definition; the test shows the message without the source, and checks the line with which
the hint replaces it.

  $ try () { # SIGNATURE LINE CORRECTED-LINE
  >   printf 'import Control\nimport Geometry\nf :: %s\n%s\n' "$1" "$2" > program.frob
  >   frobc check program.frob 2>&1 | grep '^error\|hint'
  >   printf 'import Control\nimport Geometry\nf :: %s\n%s\n' "$1" "$3" > corrected.frob
  >   frobc check corrected.frob 2>&1 | grep '^error'
  > }

The angle and the distance of a polar coordinate are exchanged:

  $ try 'Distance -> Angle -> Distance' 'f d a = d + a * sin d' 'f d a = d + d * sin a'
  error[E0320]: expected no unit, found `m`
    = hint: `a` is an angle, and `d` is in `m`: write `d * sin a`
  [1]

  $ try 'Distance -> Angle -> Vec2[m]' 'f d a = Vec2 { x = 2 * cos d * a, y = d * sin a }' \
  >   'f d a = Vec2 { x = 2 * cos a * d, y = d * sin a }'
  error[E0320]: expected no unit, found `m`
    = hint: `a` is an angle, and `d` is in `m`: write `2 * cos a * d`
  [1]

A factor that is not an angle is not exchanged:

  $ try 'Distance -> Float -> Float' 'f d k = k * sin d' 'f d k = k * sin (d / 1[m])'
  error[E0320]: expected no unit, found `m`
    = hint: if `d` is of type `Angle`, write the signature as `f :: Angle -> Float -> Float`
    = hint: to get a plain number, divide by the unit: `d / 1[m]`
  [1]

`derivative` in place of `integral`, in the definition of a name:

  $ try 'SF Velocity Distance' 'f = proc v -> 2 * way where way = derivative v' 'f = proc v -> 2 * way where way = integral v'
  error[E0320]: expected the unit `m`, found `m/s^2`
    = hint: for the sum over time, write `integral v`
  [1]

  $ try 'SF Distance Velocity' 'f = proc d -> 0.5 * integral d' 'f = proc d -> 0.5 * derivative d'
  error[E0320]: expected the unit `m/s`, found `m s`
    = hint: for the rate of change, write `derivative d`
  [1]

  $ try 'SF (Distance, Velocity) Distance' 'f = proc (d, v) -> d + way where way = derivative v' \
  >   'f = proc (d, v) -> d + way where way = integral v'
  error[E0320]: the operands of `+` have different units: `m` and `m/s^2`
    = hint: for the sum over time, write `integral v`
  [1]

A power too many:

  $ try 'Distance -> Angle -> Distance' 'f d a = d ^ 2 * cos a' 'f d a = d * cos a'
  error[E0320]: expected the unit `m`, found `m^2`
    = hint: use `d` in place of `d ^ 2` to get the expected unit: write `d * cos a`
    = hint: if this is the right result, write the signature as `f :: Distance -> Angle -> Float[m^2]`
  [1]

  $ try 'Distance -> Angle -> Vec2[m]' 'f d a = p where p = Vec2 { x = d ^ 2 * cos a, y = d * sin a }' \
  >   'f d a = p where p = Vec2 { x = d * cos a, y = d * sin a }'
  error[E0320]: expected the unit `m`, found `m^2`
    = hint: for a field in `m`, write `d * cos a`
  error[E0320]: expected the unit `m^2`, found `m`
    = hint: the two fields must have the same unit: if `d * sin a` is right, write `x = d * cos a`
  [1]

The unit of a sum is known from its place, or from the gain of the other operand:

  $ try 'SF Distance AngularVelocity' 'f = proc e -> limit 1[rad/s] (4 * e + 3[1/m] * derivative e)' \
  >   'f = proc e -> limit 1[rad/s] (4[1/m/s] * e + 3[1/m] * derivative e)'
  error[E0320]: the operands of `+` have different units: `m` and `1/s`
    = hint: if the gain `4` should have a unit, like the gain in the other operand, write `4[1/m/s]`
  [1]

  $ try 'SF Distance AngularVelocity' 'f = proc e -> 4[1/(m s)] * e + 3 * derivative e' \
  >   'f = proc e -> 4[1/(m s)] * e + 3[1/m] * derivative e'
  error[E0320]: the operands of `+` have different units: `1/s` and `m/s`
    = hint: if the gain `3` should have a unit, like the gain in the other operand, write `3[1/m]`
  [1]

  $ try 'SF Distance AngularVelocity' 'f = proc e -> turn where turn = 4 * e + 3[1/m] * derivative e' \
  >   'f = proc e -> turn where turn = 4[1/m/s] * e + 3[1/m] * derivative e'
  error[E0320]: the operands of `+` have different units: `m` and `1/s`
    = hint: if the gain `4` should have a unit, like the gain in the other operand, write `4[1/m/s]`
  [1]

`limit` with two limits, in a long line:

  $ try 'Distance -> AngularVelocity' 'f off = limit (-1[rad/s]) 1[rad/s] (4[1/(m s)] * off + 3[1/m] * off / 0.5[s])' \
  >   'f off = clamp (-1[rad/s]) 1[rad/s] (4[1/(m s)] * off + 3[1/m] * off / 0.5[s])'
  error[E0302]: `limit` takes 2 arguments, but is given 3
    = hint: `limit` takes one limit for both directions; for two limits, write `clamp (-1[rad/s]) 1[rad/s] (4[1/(m s)] * off + 3[1/m] * off / 0.5[s])`
  [1]
