Units that require a gain, a power, or a declaration.

  $ cat > type_unit_scaled.frob <<'FROB'
  > limitCm :: Float[cm] -> Float[cm]
  > limitCm x = min x 50[cm]
  > main = proc x -> limitCm x
  > FROB
  $ frobc check type_unit_scaled.frob
  error[E0321]: a type cannot contain a scaled unit, because values are stored in base units
   --> type_unit_scaled.frob:1:18
    |
  1 | limitCm :: Float[cm] -> Float[cm]
    |                  ^^           -- and here
    |
    = hint: write `m` here; use scaled units only after literals
  
  1 error
  [1]

  $ cat > add_angle_length.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v w) where
  >     v = 0.2[m/s]
  >     w = frontSonar i - 0.5[m])
  > FROB
  $ frobc check add_angle_length.frob
  error[E0320]: expected the unit `1/s`, found `m`
   --> add_angle_length.frob:2:54
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR v w) where
    |                                           --------   ^ this is `Float[m]`
    |                                           |
    |                                           argument 2 of `setVelTR` is `AngularVelocity` (1/s)
    |
    = hint: to convert `m` to `1/s`, multiply by a gain, as in `2[1/m/s] * w`
  
  1 error
  [1]

  $ cat > sqrt_sum.frob <<'FROB'
  > dist :: Float[m] -> Float[m] -> Float[m]
  > dist x y = sqrt (x^2 + y)
  > main = proc (x, y) -> dist x y
  > FROB
  $ frobc check sqrt_sum.frob
  error[E0320]: the operands of `+` have different units: `m^2` and `m`
   --> sqrt_sum.frob:2:24
    |
  2 | dist x y = sqrt (x^2 + y)
    |                  ---   ^ this is `Float[m]`
    |                  |
    |                  this is `Float[m^2]`
    |
    = hint: to use the square, write `y ^ 2`
  
  1 error
  [1]

  $ cat > miles.frob <<'FROB'
  > a = 3[mph]
  > b = 4[mph]
  > c :: Float[mph]
  > c = a + 5[mph]
  > main = proc x -> x * a
  > FROB
  $ frobc check miles.frob
  error[E0208]: unknown unit `mph`
   --> miles.frob:1:7
    |
  1 | a = 3[mph]
    |       ^^^
  2 | b = 4[mph]
    |       --- and here
  3 | c :: Float[mph]
    |            --- and here
  4 | c = a + 5[mph]
    |           --- and here
    |
    = hint: write `1.34112[m/s]`, or declare the unit on a line of its own: `unit mph = 0.44704 m/s`
  
  1 error
  [1]

A turn rate that is a plain signal times a speed:

  $ cat > side.frob <<'FROB'
  > import Robot
  > main :: SF RobotInput RobotOutput
  > main = proc i -> roMake (setVelTR 0.2[m/s] omega) where
  >     side = if bumpedLeft i then -1 else 1
  >     omega = 0.4[m/s] * side
  > FROB
  $ frobc check side.frob 2>&1 | grep -e ^error -e hint
  error[E0320]: expected the unit `1/s`, found `m/s`
    = hint: write `0.4[rad/s]` if you meant that unit
  $ sed 's/0.4.m.s./0.4[rad\/s]/' side.frob > pasted.frob && frobc check pasted.frob

A limit in m/s for a distance lacks a gain, unless its unit is wrong:

  $ for e in 'min 0.3[m/s] (d - 0.4[m])' 'min (d - 0.4[m]) 0.3[m/s]' 'max 0 (min 0.3[m/s] d)' 'min 0.3[m] (0.5[1/s] * d)'; do
  >   printf 'main :: SF Distance Velocity\nmain = proc d -> v where\n    v = %s\n' "$e" > limit.frob
  >   frobc check limit.frob 2>&1 | grep -e ^error -e hint -e 'if you'
  > done
  error[E0320]: expected the unit `m`, found `m/s`
    = hint: to convert `m` to `m/s`, multiply by a gain, as in `0.5[1/s] * (d - 0.4[m])`
    = hint: write `0.3[m]` if you meant that unit
  error[E0320]: expected the unit `m`, found `m/s`
    = hint: to convert `m` to `m/s`, multiply by a gain, as in `0.5[1/s] * (d - 0.4[m])`
    = hint: write `0.3[m]` if you meant that unit
  error[E0320]: expected the unit `m`, found `m/s`
    = hint: to convert `m` to `m/s`, multiply by a gain, as in `0.5[1/s] * d`
    = hint: write `0.3[m]` if you meant that unit
  error[E0320]: expected the unit `m/s`, found `m`
    = hint: write `0.3[m/s]` if you meant that unit
  $ for e in 'min 0.3[m/s] (0.5[1/s] * (d - 0.4[m]))' 'min (0.5[1/s] * (d - 0.4[m])) 0.3[m/s]' 'max 0 (min 0.3[m/s] (0.5[1/s] * d))'; do
  >   sed "s| v = .*| v = $e|" limit.frob > pasted.frob && frobc check pasted.frob
  > done
