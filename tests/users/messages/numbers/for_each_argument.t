Arguments and factors of another type than expected.

A number that is not an Int is not replaced by a 0:

  $ cat > index.frob <<'FROB'
  > main :: SF (Array 4 Float, Float) Float
  > main = proc (xs, k) -> at k 0 xs
  > FROB
  $ frobc check index.frob
  error[E0312]: expected `Int`, found `Float`
   --> index.frob:2:27
    |
  2 | main = proc (xs, k) -> at k 0 xs
    |                        -- ^
    |                        |
    |                        argument 1 of `at` is `Int`
    |
    = hint: write `round k`, or use `floor`, `ceiling` or `truncate` instead of `round`
  
  1 error
  [1]

  $ cat > one_tuple.frob <<'FROB'
  > foreign add :: (Float, Float) -> Float = "add"
  > main :: SF Float Float
  > main = proc x -> add x x
  > FROB
  $ frobc check one_tuple.frob
  error[E0301]: expected `(Float, Float)`, found `Float`
   --> one_tuple.frob:3:22
    |
  3 | main = proc x -> add x x
    |                  --- ^
    |                  |
    |                  argument 1 of `add` is `(Float, Float)`
    |
    = hint: `add` takes one tuple with 2 elements: write `add (x, x)`
  
  1 error
  [1]

  $ cat > knob.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = knob "speed" 0.1[m/s] i)
  > FROB
  $ frobc check knob.frob
  error[E0301]: expected `Velocity` (m/s), found the function `Float[m/s] -> a -> Float[m/s]`
   --> knob.frob:2:52
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
    |                                           -------- ^
    |                                           |
    |                                           argument 1 of `setVelTR` is `Velocity` (m/s)
  3 |     v = knob "speed" 0.1[m/s] i)
    |         ----------------------- this is `v`; it lacks two arguments
    |
    = hint: `knob` takes 5 arguments: `knob :: String -> Float[u] -> Float[u] -> Float[u] -> i -> Float[u]`
  
  1 error
  [1]

  $ cat > gain.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] (2 * (sideSonar i - 0.5[m]))))
  > FROB
  $ frobc check gain.frob
  error[E0320]: expected the unit `1/s`, found `m`
   --> gain.frob:2:62
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] (2 * (sideSonar i - 0.5[m]))))
    |                                           --------           ^^^^^^^^^^^^^^^^^^^^^^^^^^ this is `Float[m]`
    |                                           |
    |                                           argument 2 of `setVelTR` is `AngularVelocity` (1/s)
    |
    = hint: if the factor `2` has a unit, write it: `2[1/m/s]`
  
  1 error
  [1]

  $ cat > celsius.frob <<'FROB'
  > import Robot
  > warm :: Float[C]
  > warm = 21[C]
  > main = reactimateRobot (proc i -> roMake (setVelTR 0 0))
  > FROB
  $ frobc check celsius.frob
  error[E0208]: unknown unit `C`
   --> celsius.frob:2:15
    |
  2 | warm :: Float[C]
    |               ^
  3 | warm = 21[C]
    |           - and here
    |
    = hint: use kelvin, `K`, for a temperature: 0 degrees Celsius is `273.15[K]`
    = hint: for a coulomb, write `A s`
  
  1 error
  [1]
