let made_into_int = "`round`, `floor`, `ceiling` and `truncate` make an Int of a Float"
let made_into_float = "`toFloat n` makes a Float of an Int"
let whole_division = "`div` and `mod` of Ints round to minus infinity"
let wrapped = "it is `wrapAngle a`: `import Geometry`"
let clamped = "it is `clamp low high x`: `import Control`"
let no_module = "the functions on numbers need no module: `abs x`, `sqrt x`"
let filled = "`generate (const 0)` makes an array of as many elements as its type says"
let fixed_size = "an array keeps its size: `replace i x xs` has another element at i"

let number = function
  | "fromIntegral" | "fromInteger" | "realToFrac" | "float" -> Some made_into_float
  | "int" | "toInt" | "rint" | "lround" | "lroundf" | "nearbyint" -> Some made_into_int
  | "ceil" | "ceilf" -> Some "`ceiling` makes an Int, `ceilingFloat` a Float"
  | "floorf" -> Some "`floor` makes an Int, `floorFloat` a Float"
  | "trunc" | "truncf" -> Some "it is `truncate`, which makes an Int"
  | "pow" | "powf" -> Some "a power is `x ** y`, or `x ^ 2` with a literal exponent"
  | "sq" | "square" | "sqr" -> Some "it is `x ^ 2`"
  | "exp2" -> Some "it is `2 ** x`"
  | "ln" -> Some "it is `log`"
  | "log10" | "log2" -> Some "the natural logarithm is `log`: to the base 10 it is `log x / log 10`"
  | "sinh" | "cosh" | "tanh" -> Some "it is made of `exp`: tanh x is `1 - 2 / (exp (2 * x) + 1)`"
  | "fabs" | "fabsf" -> Some "it is `abs`"
  | "fmin" | "fminf" -> Some "it is `min`"
  | "fmax" | "fmaxf" -> Some "it is `max`"
  | "sgn" | "sign" -> Some "it is `signum`"
  | "copysign" | "copysignf" -> Some "it is `if y < 0 then -(abs x) else abs x`"
  | "fmod" | "fmodf" | "remainder" ->
      Some
        "of Floats it is `x - y * floorFloat (x / y)`, which has the sign of y; of angles, \
         `wrapAngle`"
  | "rem" | "quot" | "divMod" | "quotRem" -> Some whole_division
  | "testBit" -> Some "it is `x .&. shiftL 1 n /= 0`"
  | "shift" | "unsafeShiftL" | "unsafeShiftR" -> Some "bits are moved by `shiftL` and `shiftR`"
  | "even" -> Some "it is `mod n 2 == 0`"
  | "odd" -> Some "it is `mod n 2 == 1`"
  | "constrain" | "clip" | "saturate" -> Some clamped
  | "lerp" -> Some "it is `a + t * (b - a)`"
  | "nan" | "isnan" | "isNaN" -> Some "NaN is the only number with `x /= x`; it is written `0 / 0`"
  | "inf" | "isinf" | "isInfinite" | "isfinite" | "isFinite" ->
      Some "`x - x == 0` tells that x is finite; infinity is written `1 / 0`"
  | "deg2rad" | "radians" | "toRadians" | "to_radians" ->
      Some "angles are in radians, and `90[deg]` is one; x degrees are `x * 1[deg]`"
  | "as" -> Some "nothing is converted: how many of a unit there are in x is `x / 1[deg]`"
  | "rad2deg" | "degrees" | "toDegrees" | "to_degrees" -> Some "an angle in degrees is `a / 1[deg]`"
  | "wrapToPi" | "wrap_angle" | "wrap_to_pi" | "normalizeAngle" | "normalize_angle" -> Some wrapped
  | "angle_diff" | "shortest_angular_distance" -> Some "it is `angleDiff a b`: `import Geometry`"
  | "math" | "np" | "numpy" -> Some no_module
  | "random" | "rand" | "randn" ->
      Some "noise that is the same in each run is `whiteNoise 1 ()`, of a seed: `import Sources`"
  | _ -> None

let data = function
  | "null" | "nil" | "none" | "nullptr" -> Some "what may be missing is a `Maybe`: it is `Nothing`"
  | "fromJust" -> Some "`fromMaybe x m` is what is in `m`, and `x` where there is nothing"
  | "isJust" | "isNothing" ->
      Some "`maybe False (const True) m` tells whether there is something in `m`"
  | "fmap" -> Some "it is `map` on arrays, `mapE` on events, `mapT` on the results of tasks"
  | "product" -> Some "`foldl (*) 1 xs` multiplies the elements of an array"
  | "average" | "avg" -> Some "it is `mean xs`"
  | "minimum" -> Some "the least element of an array is `minimumBy id xs`"
  | "maximum" -> Some "the greatest element of an array is `maximumBy id xs`"
  | "foldr" | "reduce" -> Some "arrays are folded from the first element on: `foldl f x xs`"
  | "filter" | "partition" | "takeWhile" | "dropWhile" ->
      Some
        "an array keeps its size: `map (\\x -> if p x then x else 0) xs` has 0 for what is left \
         out, which a `sum` does not see"
  | "zip" -> Some "`zipWith (\\x y -> (x, y)) xs ys` makes pairs"
  | "enumerate" -> Some "`imap (\\i x -> (i, x)) xs` has each element with its index"
  | "zeros" | "ones" | "replicate" -> Some filled
  | "append" | "concat" | "push_back" -> Some fixed_size
  | "len" | "sizeof" -> Some "the size of an array is `length xs`"
  | _ -> None

let activity = function
  | "pure" -> Some "it is `return`"
  | "mapM" | "mapM_" | "forM" | "forM_" | "traverse" | "traverse_" ->
      Some "tasks one after the other are `forEachT xs f`"
  | "show" | "print" | "putStrLn" | "printf" | "disp" | "fprintf" ->
      Some "nothing is printed: what is to be seen is an output, and `--record` writes all of them"
  | "analogRead" | "digitalRead" -> Some "what is read is a part of the program's input"
  | "analogWrite" | "digitalWrite" -> Some "what is written is a part of the program's output"
  | "sleep" | "usleep" | "wait" | "delayMicroseconds" ->
      Some "a task that waits is `sleepT 2[s] restingOutput`, with the robot at rest"
  | "while" ->
      Some
        "a task again and again is `forever t`, and `whileT condition t` while a signal function \
         gives True; until something happens, `abortWhen`"
  | "end" | "endif" | "fi" | "done" | "begin" ->
      Some "a block ends where its indentation does, and needs no word for it"
  | "for" | "foreach" | "forEach" ->
      Some "`map f xs` is each element's; tasks one after the other are `forEachT xs f`"
  | "millis" | "micros" -> Some "`time ()` is the time since the start, in seconds"
  | "localTime" -> Some "it is `time`"
  | "dt" | "deltaTime" | "delta_t" ->
      Some
        "`integral x` and `derivative x` know the time by themselves; `stepTime ()` of `Control` \
         is the time since the instant before"
  | "assert" | "assume" ->
      Some
        "an assertion is an equation of a `proc`, and no task or value: `proc i -> y where`, with \
         `assert \"label\" (y > 0)` below"
  | "undefined" -> Some "a program never stops at a fault: what may have no value is a `Maybe`"
  | _ -> None

let signal_function = function
  | "iPre" | "pre" -> Some "it is `delay x0`"
  | "prev" | "previousValue" | "lastValue" | "old" | "last" | "unitDelay" | "memory" ->
      Some "the value of the instant before is `delay x0 x`; at the first instant it is `x0`"
  | "integrate" | "cumtrapz" -> Some "it is `integral`"
  | "deriv" | "differentiate" -> Some "it is `derivative`"
  | "until" | "untilB" ->
      Some
        "one signal function until an event, and then another, is `switch`; a task until an event \
         is ``t `abortWhen` sf``"
  | "repeatedly" -> Some "it is `every q`, whose events are `()`"
  | "filterE" -> Some "it is `filterEvent`"
  | "lMerge" -> Some "it is `mergeE`"
  | "rMerge" -> Some "it is `mergeR`"
  | "joinE" | "pairE" -> Some "it is `pairEvents`"
  | "iEdge" -> Some "it is `edgeFrom`"
  | "attach" -> Some "it is `snapshot`, on signals of events"
  | "par" | "parA" ->
      Some "`parB sfs` runs an array of signal functions on one input, `parZ sfs` each on its own"
  | "reactimate" ->
      Some "`reactimateRobot` makes a program of a signal function; any other is traced as it is"
  | _ -> None

let robot = function
  | "heading" | "theta" | "yaw" | "orientation" | "compass" ->
      Some "the direction in which the robot looks is `(robotPose i).heading`"
  | "pose" | "odom" | "odometry" | "position" | "getPose" | "get_pose" ->
      Some
        "where the robot is: `place i`, with the fields `x` and `y`, and `robotPose i`, with \
         `position` and `heading`"
  | "sonar" | "sonarFront" | "front_sonar" | "ultrasonic" | "laser" | "lidar" | "frontDistance"
  | "getDistance" | "get_distance" | "ping" ->
      Some
        "the distance ahead is `frontSonar i`, to the left `sideSonar i`, to the right `rightSonar \
         i`"
  | "leftSonar" | "sonarLeft" | "left_sonar" -> Some "the distance to the left is `sideSonar i`"
  | "sonarRight" | "right_sonar" -> Some "the distance to the right is `rightSonar i`"
  | "bump" | "bumper" | "isBumped" | "bumperPressed" ->
      Some "`bumped i` tells whether the robot touches something"
  | "setSpeed" | "setVelocity" | "set_velocity" | "setVel" | "setMotors" | "setMotorSpeed"
  | "cmd_vel" | "cmdVel" | "publish" | "drive" | "motor" | "motors" ->
      Some "a robot's output is `roMake (setVelTR v omega)`: its speed, and how fast it turns"
  | "turnLeft" | "turn_left" | "turnRight" | "turn_right" | "turn" ->
      Some "a task that turns on the spot is `turnBy 90[deg]`, to the left if it is positive"
  | "moveForward" | "move_forward" | "driveForward" | "goForward" | "move" | "driveStraight" ->
      Some "a task that drives straight ahead is `forward 1[m]`"
  | "red" | "green" | "blue" | "yellow" | "orange" ->
      Some
        "a colour that a camera looks for is a range of one's own: `ColourRange { hueFrom = \
         340[deg], hueTo = 20[deg], … }`, with `import Vision`"
  | "stop" | "halt" | "stopMotors" -> Some "a robot at rest has the output `restingOutput`"
  | _ -> None

let value name = List.find_map (fun hint -> hint name) [ number; data; activity; signal_function ]

let is_statement = function
  | "while" | "for" | "foreach" | "print" | "printf" | "disp" | "fprintf" -> true
  | _ -> false

let constructor = function
  | "None" | "Null" | "NULL" -> Some "it is `Nothing`"
  | "Some" -> Some "it is `Just`"
  | "Twist" -> Some "a robot's speed and turn are told by `setVelTR v omega`"
  | "TRUE" -> Some "it is `True`"
  | "FALSE" -> Some "it is `False`"
  | "PI" | "M_PI" -> Some "it is `pi`"
  | "TWO_PI" | "TAU" -> Some "it is `2 * pi`"
  | "HALF_PI" | "M_PI_2" -> Some "it is `pi / 2`"
  | "NAN" | "NaN" -> Some "NaN is written `0 / 0`"
  | "INFINITY" | "Infinity" -> Some "infinity is written `1 / 0`"
  | _ -> None

let module_ = function
  | "Math" | "Maths" | "Numeric" -> Some no_module
  | "Time" | "Clock" -> Some "time needs no module: `time ()` is the time since the start"
  | "List" | "Array" | "Vector" | "Arrays" ->
      Some "arrays need no module: `map f xs`, `foldl (+) 0 xs`"
  | "Random" -> Some "random numbers are `whiteNoise 1 ()`: `import Sources`"
  | _ -> None

let type_ = function
  | "IO" -> Some "a program's `main` is a `Program RobotInput RobotOutput`, or a signal function"
  | "Str" | "Char" | "Text" | "CString" -> Some "a text is a `String`, and only a label"
  | "List" | "Vector" | "Vec" -> Some "several of one type are an array: `Array 4 Float`"
  | "Number" | "Real" | "Num" | "Decimal" | "Rational" -> Some "numbers are `Float` or `Int`"
  | "Optional" | "Option" -> Some "what may be missing is a `Maybe`"
  | "Duration" | "Seconds" -> Some "it is `Time`"
  | "Speed" -> Some "it is `Velocity`"
  | "Length" -> Some "it is `Distance`"
  | "Twist" -> Some "a robot's speed and turn are told by `setVelTR v omega`"
  | "Signal" | "Behavior" | "Behaviour" ->
      Some
        "a variable of a `proc` is a signal by itself: its type is that of its values, as `Float`"
  | _ -> None

let class_ = function
  | "Num" | "Fractional" | "Floating" | "Real" | "Integral" | "RealFrac" ->
      Some
        "numbers have no classes: `n[u]` is any number, of any unit, as in `twice :: n[u] -> \
         n[u]`; `Float[u]` has fractions"
  | "Show" | "Read" -> Some "leave it out: a trace shows values of every type"
  | "Functor" | "Applicative" | "Monad" | "Foldable" | "Traversable" | "Semigroup" | "Monoid" ->
      Some "a class is of types, not of what makes types of others"
  | "Enum" | "Bounded" -> Some "a `case` gives each constructor its number"
  | _ -> None
