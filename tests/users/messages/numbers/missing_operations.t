Formulas that lack an operation or have the wrong one, and conversions. Each program is one line
under a signature; the test shows the message without the source, and checks the line with which the
hint replaces it.

  $ try () { # SIGNATURE LINE CORRECTED-LINE
  >   printf 'import Control\nf :: %s\n%s\n' "$1" "$2" > program.frob
  >   frobc check program.frob 2>&1 | grep '^error\|hint'
  >   printf 'import Control\nf :: %s\n%s\n' "${4:-$1}" "$3" > corrected.frob; frobc check corrected.frob 2>&1 | grep '^error'
  > }

  $ try 'Distance -> Velocity' 'f d = sqrt (2 * d)' 'f d = sqrt (1[m/s^2] * 2 * d)'
  error[E0320]: expected the unit `m/s`, found `m^(1/2)`
    = hint: multiply by a factor in `m/s^2`, an acceleration, inside the root, as in `sqrt (1[m/s^2] * 2 * d)`
  [1]
  $ try 'Distance -> Distance -> Distance' 'f x y = sqrt (x + y)' 'f x y = sqrt (x ^ 2 + y ^ 2)'
  error[E0320]: expected the unit `m`, found `m^(1/2)`
    = hint: for the root of a sum of squares, write `sqrt (x ^ 2 + y ^ 2)`
  [1]
  $ try 'SF Distance Velocity' 'f = proc x -> integral x' 'f = proc x -> derivative x'
  error[E0320]: expected the unit `m/s`, found `m s`
    = hint: for the rate of change, write `derivative x`
    = hint: if the types of the signature are in the wrong order, write it as `f :: SF Velocity Distance`
  [1]
  $ try 'SF Velocity Distance' 'f = proc v -> derivative v' 'f = proc v -> integral v'
  error[E0320]: expected the unit `m`, found `m/s^2`
    = hint: for the sum over time, write `integral v`
    = hint: if the types of the signature are in the wrong order, write it as `f :: SF Distance Velocity`
  [1]
  $ try 'SF Velocity Velocity' 'f = proc v -> delay 0.5[s] v' 'f = proc v -> delayBy 0.5[s] v'
  error[E0320]: expected the unit `s`, found `m/s`
    = hint: to delay by a fixed time, write `delayBy 0.5[s] v`, with `import Control`; `delay x0` delays by one instant, and `x0` is its output at the first instant
  [1]
  $ try 'Float[1/(m s)] -> Float[1/(m s)] -> SF Distance AngularVelocity' 'f kp kd = proc e -> kp * e + kd * derivative e' \
  >   'f kp kd = proc e -> kp * e + kd * derivative e' 'Float[1/(m s)] -> Float[1/m] -> SF Distance AngularVelocity'
  error[E0320]: the operands of `+` have different units: `1/s` and `1/s^2`
    = hint: the gain of a rate of change needs a different unit: in the signature, write `Float[1/m]` as the type of `kd`
  [1]
  $ try 'Distance -> Int' 'f d = round (d * 100)' 'f d = round (d * 100 / 1[m])'
  error[E0320]: expected no unit, found `m`
    = hint: divide by the unit before rounding: `round (d * 100 / 1[m])`
    = hint: if this is the right result, write the signature as `f :: Distance -> Int[m]`
  [1]
  $ try 'Distance -> Float' 'f d = toFloat (d / 1[m])' 'f d = d / 1[m]'
  error[E0312]: expected `Int`, found `Float`
    = hint: remove `toFloat`: `d / 1[m]` is already a `Float`
  [1]
  $ try 'Float -> Int' 'f x = max 0 (255 * x)' 'f x = round (max 0 (255 * x))'
  error[E0312]: expected `Int`, found `Float`
    = hint: write `round (max 0 (255 * x))`, or use `floor`, `ceiling` or `truncate` instead of `round`
  [1]
  $ try 'Int -> Int -> Float' 'f total n = total / n' 'f total n = toFloat total / toFloat n'
  error[E0312]: expected `Float`, found `Int`
    = hint: for a whole number, write `div total n`, which rounds down; for a number with a fraction, write `toFloat total / toFloat n`
  [1]
  $ try 'Velocity' 'f = 3[m per s]' 'f = 3[m/s]'
  error[E0208]: unknown unit `per`
    = hint: write `/` for "per", as in `0.3[m/s]`
  [1]
  $ try 'SF Distance AngularVelocity' 'f = proc d -> limit 1[rad/s] (2 * d)' 'f = proc d -> limit 1[rad/s] (2[1/m/s] * d)'
  error[E0320]: expected the unit `1/s`, found `m`
    = hint: if the factor `2` has a unit, write it: `2[1/m/s]`
  [1]
  $ try 'Float -> Float' 'f a b = (a + b) / 2' 'f a b = (a + b) / 2' 'Float -> Float -> Float'
  error[E0302]: `f` has more than one parameter, but its type allows only one
    = hint: the signature needs a type for each parameter (`a`, `b`) and one for the result: `f :: … -> … -> …`
  [1]
  $ try 'AngularVelocity -> Float' 'f w = sin 0.5[rad/s]' 'f w = sin 0.5[rad]'
  error[E0320]: expected no unit, found `1/s`
    = hint: an angle is a rate times a time: in a `proc`, write `sin (0.5[rad/s] * time ())`
  [1]
  $ try 'SF Float Bool' 'f = proc x -> if x > 2 then 1 else 0' 'f = proc x -> if x > 2 then True else False'
  error[E0301]: expected `Bool`, found a number
    = hint: use `True`: a number is not a `Bool`
  [1]
  $ try 'Distance -> Distance -> Angle' 'f x y = atan y x' 'f x y = atan2 y x'
  error[E0320]: expected no unit, found `m`
    = hint: `atan` takes one argument: to compute an angle from two sides, write `atan2 y x`
  [1]
  $ try 'SF Distance Velocity' 'f = derivative . lowPass 0.2[s]' 'f = lowPass 0.2[s] >>> derivative'
  error[E0304]: expected a function, found a signal function: `SF Float[u] Float[u/s]`
    = hint: compose signal functions from left to right with `>>>`: `lowPass 0.2[s] >>> derivative`
  [1]
  $ try '[Float] -> Float' 'f xs = sum xs' 'f xs = sum xs' 'Array n Float -> Float'
  error[E0110]: the type of an array cannot be written in brackets
    = hint: write `f :: Array n Float -> Float`, or with a number instead of the size `n`
  [1]
  $ try 'SF (Event Int) (Event Int)' 'f = proc e -> filter (\n -> n > 3) e' 'f = proc e -> filterEvent (\n -> n > 3) e'
  error[E0205]: unknown name `filter`
    = hint: write `filterEvent`
  [1]
  $ try 'SF Bool Bool' 'f = proc b -> hold False b' 'f = proc b -> hold False (tag (edge b) True)'
  error[E0301]: expected `Event Bool`, found `Bool`
    = hint: use `tag (edge b) True`, which occurs when the condition becomes True
  [1]
  $ try 'SF Float Float' 'f = proc x -> lowPassFilter 0.5[s] x' 'f = proc x -> lowPass 0.5[s] x'
  error[E0205]: unknown name `lowPassFilter`
    = hint: write `lowPass 0.5[s] x`
  [1]
  $ try 'SF Boolean Float' 'f = proc b -> if b then 1 else 0' 'f = proc b -> if b then 1 else 0' 'SF Bool Float'
  error[E0207]: unknown type `Boolean`
    = hint: write `Bool`
  [1]

The second equation overrides the first one:

  $ printf 'main :: SF Bool Float\nmain = proc b -> v where\n    v = 1\n    v = if b then 0 else v\n' > twice.frob
  $ frobc check twice.frob 2>&1 | grep '^error\|hint'
  error[E0212]: `v` is defined twice here
    = hint: write one equation, `v = if b then 0 else 1`, because an equation holds at every instant, unlike an assignment
