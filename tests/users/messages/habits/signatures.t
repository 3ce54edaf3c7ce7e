Types, parameters and guards in the notation of other languages. The hint contains the user's own
signature or call in Frob. The test shows the message without the source, and checks the program
with the hint's text.

  $ try () { # PROGRAM CORRECTED
  >   printf "import Control\nimport Robot\n$1\n" > program.frob
  >   frobc check program.frob 2>&1 | grep '^error\|hint'
  >   printf "import Control\nimport Robot\n$2\n" > corrected.frob
  >   frobc check corrected.frob 2>&1 | grep '^error'
  > }

Lower-case names of types, with one colon or two:

  $ try 'f : distance -> velocity\nf d = 0.5[1/s] * d' 'f :: Distance -> Velocity\nf d = 0.5[1/s] * d'
  error[E0103]: unexpected character `:`
    = hint: put `::` before a type: `f :: Distance -> Velocity`
  [1]
  $ try 'f :: distance -> velocity\nf d = 0.5[1/s] * d' 'f :: Distance -> Velocity\nf d = 0.5[1/s] * d'
  error[E0306]: the signature allows any type `distance`, but the definition needs it to be `Float[u]`
    = hint: if you meant the type, write `Distance -> Velocity`; a lower-case name means any type
  [1]
  $ try 'f :: distance -> angularVelocity\nf d = if d > 1[m] then 0 else 1[rad/s]' 'f :: Distance -> AngularVelocity\nf d = if d > 1[m] then 0 else 1[rad/s]'
  error[E0306]: the signature allows any type `distance`, but the definition needs it to be a number in `m`
    = hint: if you meant the type, write `Distance -> AngularVelocity`; a lower-case name means any type
  error[E0306]: the signature allows any type `angularVelocity`, but the definition needs it to be a number
    = hint: if you meant the type, write `Distance -> AngularVelocity`; a lower-case name means any type
  [1]
  $ try 'f :: float -> float -> bool\nf x y = x < y' 'f :: Float -> Float -> Bool\nf x y = x < y'
  error[E0306]: the signature allows any type `bool`, but the definition needs it to be `Bool`
    = hint: if you meant the type, write `Float -> Float -> Bool`; a lower-case name means any type
  error[E0309]: `<` needs `Ord float`, which the signature of `f` does not declare
    = hint: `float` is a type variable, because it starts with a lower-case letter: for the type, write `Float`
  [1]
  $ try 'f :: event float -> float\nf e = fromEvent 0 e' 'f :: Event Float -> Float\nf e = fromEvent 0 e'
  error[E0110]: expected `->` or the end of this type, found `float`
    = hint: start the name of a type with a capital letter: write `f :: Event Float -> Float`
  [1]
  $ try 'f :: sf float bool\nf = proc x -> x > 1' 'f :: SF Float Bool\nf = proc x -> x > 1'
  error[E0110]: expected `->` or the end of this type, found `float`
    = hint: start the name of a type with a capital letter: write `f :: SF Float Bool`
  [1]

Arrays without their size, and arguments in brackets:

  $ try 'f :: Array Distance -> Distance\nf xs = sum xs' 'f :: Array n Distance -> Distance\nf xs = sum xs'
  error[E0216]: type `Array` takes 2 type arguments, not 1
    = hint: write `f :: Array n Distance -> Distance`, or with a number instead of the size `n`
  [1]
  $ try 'f :: Array Distance 2 -> Distance\nf xs = sum xs' 'f :: Array 2 Distance -> Distance\nf xs = sum xs'
  error[E0330]: expected the size of an array, found the type `Distance` (m)
    = hint: write the size first: `f :: Array 2 Distance -> Distance`
  [1]
  $ try 'f :: Array[Float, 4] -> Float\nf xs = sum xs' 'f :: Array 4 Float -> Float\nf xs = sum xs'
  error[E0119]: the brackets after a type contain a unit, not the size of an array
    = hint: write `f :: Array 4 Float -> Float`
  [1]
  $ try 'f :: List[float] -> float\nf xs = sum xs' 'f :: Array n Float -> Float\nf xs = sum xs'
  error[E0207]: unknown type `List`
    = hint: write `f :: Array n Float -> Float`, or with a number instead of the size `n`
  [1]
  $ try 'f :: Vec<float> -> Float\nf xs = sum xs' 'f :: Array n Float -> Float\nf xs = sum xs'
  error[E0110]: expected `->` or the end of this type, found `<`
    = hint: separate type arguments with spaces, without `<>`: write `f :: Array n Float -> Float`, or with a number instead of the size `n`
  [1]
  $ try 'f :: float[] -> float\nf xs = sum xs' 'f :: Array n Float -> Float\nf xs = sum xs'
  error[E0110]: expected a unit after `[`, found `]`
    = hint: for an array, write `f :: Array n Float -> Float`, or with a number instead of the size `n`
  [1]
  $ try 'f :: Float -> [Float]\nf x = [x, x, x, x]' 'f :: Float -> Array 4 Float\nf x = [x, x, x, x]'
  error[E0110]: the type of an array cannot be written in brackets
    = hint: write `f :: Float -> Array 4 Float`, if 4 is the number of elements
  [1]
  $ try 'f :: Event[Float] -> Float\nf e = fromEvent 0 e' 'f :: Event Float -> Float\nf e = fromEvent 0 e'
  error[E0216]: type `Event` takes no unit
    = hint: write `f :: Event Float -> Float`
  [1]
  $ try 'f :: Optional[Distance] -> Distance\nf d = fromMaybe 0 d' 'f :: Maybe Distance -> Distance\nf d = fromMaybe 0 d'
  error[E0207]: unknown type `Optional`
    = hint: write `f :: Maybe Distance -> Distance`
  [1]
  $ try 'f :: Tuple[Float, Float] -> Float\nf (x, y) = x + y' 'f :: (Float, Float) -> Float\nf (x, y) = x + y'
  error[E0207]: unknown type `Tuple`
    = hint: write `f :: (Float, Float) -> Float`
  [1]
  $ try 'data Ring = Ring { ranges :: Array Distance }' 'data Ring = Ring { ranges :: Array 4 Distance }'
  error[E0216]: type `Array` takes 2 type arguments, not 1
    = hint: write the number of elements and their type, as in `Array 4 Distance`
  [1]

A tuple in place of separate arguments:

  $ try 'f v omega = roMake setVelTR(v, omega)' 'f v omega = roMake (setVelTR v omega)'
  error[E0301]: expected a function that takes one argument, found one that takes 3: `Velocity -> AngularVelocity -> a -> a`
    = hint: put parentheses around the argument: `roMake (setVelTR v omega)`
  [1]
  $ try 'f v d = setVelTR limit(v, d) 0' 'f v d = setVelTR (limit v d) 0'
  error[E0301]: expected `Velocity` (m/s), found the function `n[u] -> n[u] -> n[u]`
    = hint: put parentheses around the argument: `setVelTR (limit v d) 0`
  [1]
  $ try 'f :: SF Float Float\nf = proc x -> y where\n    y = delay(0, x)' 'f :: SF Float Float\nf = proc x -> y where\n    y = delay 0 x'
  error[E0303]: expected a value, found a signal function that is not applied to a signal
    = hint: write the arguments without parentheses or commas: `delay 0 x`
  [1]
  $ try 'f :: SF (Event Float) Float\nf = proc e -> hold(0, e)' 'f :: SF (Event Float) Float\nf = proc e -> hold 0 e'
  error[E0303]: expected a value, found a signal function that is not applied to a signal
    = hint: write the arguments without parentheses or commas: `hold 0 e`
  [1]

Guards and conditions separated by commas:

  $ try 'f :: Float -> Float\nf x\n    | x > 0, x < 1 = 2\n    | otherwise = 3' 'f :: Float -> Float\nf x\n    | x > 0 && x < 1 = 2\n    | otherwise = 3'
  error[E0110]: expected `=` after the condition of a guard, found `,`
    = hint: join two conditions with `&&`: `| x > 0 && x < 1 = 2`
  [1]
  $ try 'f :: Float -> Float\nf x\n    | x < 0 = 1, x > 2 = 5\n    | otherwise = 3' 'f :: Float -> Float\nf x\n    | x < 0 = 1\n    | x > 2 = 5\n    | otherwise = 3'
  error[E0110]: expected an operator, another guard, or the end of this definition, found `,`
    = hint: put each guard on a line of its own, without a comma: `| x < 0 = 1`, `| x > 2 = 5`
  [1]
  $ try 'f :: Float -> Float\nf x\n    | x < 0 = 1,\n    | otherwise = 3' 'f :: Float -> Float\nf x\n    | x < 0 = 1\n    | otherwise = 3'
  error[E0110]: expected an operator, another guard, or the end of this definition, found `,`
    = hint: remove the comma at the end of the line
  [1]
  $ try 'f :: Float -> Float\nf x\n    | x = 0, x > 2\n    | otherwise = 3' 'f :: Float -> Float\nf x\n    | x == 0 && x > 2 = 1\n    | otherwise = 3'
  error[E0110]: expected an operator, another guard, or the end of this definition, found `,`
    = hint: compare with `==`, and join conditions with `&&`: `| x == 0 && x > 2 = …`
  [1]
  $ try 'f x = case x of\n    y | y > 0, y < 1 -> 2\n      | otherwise -> 3' 'f x = case x of\n    y | y > 0 && y < 1 -> 2\n      | otherwise -> 3'
  error[E0110]: expected `->` after the condition of a guard, found `,`
    = hint: join two conditions with `&&`: `| y > 0 && y < 1 -> 2`
  [1]

A parameter that is read by a call:

  $ try 'speed = param("speed", 0.3[m/s])' 'param speed :: Float[m/s] = 0.3[m/s]'
  error[E0110]: a parameter must be declared at the top level
    = hint: write `param speed :: Float[m/s] = 0.3[m/s]`
  [1]
  $ try 'f x = x * param("gain", 2)' 'param gain :: Float = 2\nf x = x * gain'
  error[E0110]: a parameter must be declared at the top level
    = hint: declare the parameter as `param gain :: Float = 2` on its own line, at the left margin, and write `gain` here
  [1]
  $ try 'speed = rospy.get_param("~speed", 0.3)' 'param speed :: Float = 0.3'
  error[E0205]: unknown name `rospy`
    = hint: write `param speed :: Float = 0.3` in place of this equation
  [1]
  $ try 'f x = y where\n    y = x * get_parameter("max_gain")' 'param maxGain :: Float = 1\nf x = y where\n    y = x * maxGain'
  error[E0205]: unknown name `get_parameter`
    = hint: declare the parameter as `param maxGain :: Float = 1` on its own line, at the left margin, and write `maxGain` here
  [1]

Names of a namespace:

  $ try 'f x = Math::sqrt(x)' 'f x = sqrt x'
  error[E0110]: Frob has no `Math::`
    = hint: write `sqrt x`, without `Math::`
  [1]
  $ try 'f x y = std::max(x, y)' 'f x y = max x y'
  error[E0110]: Frob has no `std::`
    = hint: write `max x y`, without `std::`
  [1]
  $ try 'f x = Control::clamp 0 1 x' 'f x = Control.clamp 0 1 x'
  error[E0110]: Frob has no `Control::`
    = hint: write a name from a module as `Control.name`, or just `name`
  [1]

An unused turn rate beside a turn rate of 0, and an unused parameter:

  $ cat > turn.frob <<'FROB'
  > import Robot
  > drive :: SF RobotInput RobotOutput
  > drive = proc i -> roMake (setVelTR v 0) where
  >     v = 0.2[m/s]
  >     omega = (sideSonar i - 0.5[m]) * 1[rad/(m s)]
  > follow :: Distance -> SF RobotInput RobotOutput
  > follow d = drive
  > main = reactimateRobot (follow 1[m])
  > FROB
  $ frobc check turn.frob
  warning[W0304]: `omega` is defined here, but nothing uses it
   --> turn.frob:5:5
    |
  3 | drive = proc i -> roMake (setVelTR v 0) where
    |                                      - this is 0
  4 |     v = 0.2[m/s]
  5 |     omega = (sideSonar i - 0.5[m]) * 1[rad/(m s)]
    |     ^^^^^
    |
    = hint: replace this 0 with `omega`
    = hint: use it in an output, or remove it; if it is unused on purpose, rename it to `_omega`
  
  warning[W0305]: `d` is never used
   --> turn.frob:7:8
    |
  7 | follow d = drive
    |        ^
    |
    = hint: use it in the definition; if it is unused on purpose, replace it with `_` or `_d`
  
  2 warnings
  $ sed 's/v 0/v omega/' turn.frob > pasted.frob && frobc check pasted.frob 2>&1 | grep omega
  [1]
