let made_into_int = "use `round`, `floor`, `ceiling` or `truncate` to convert a Float to an Int"
let made_into_float = "use `toFloat n` to convert an Int to a Float"
let whole_division = "use `div` and `mod` for Ints: they round towards minus infinity"
let wrapped = "use `wrapAngle a`, with `import Geometry`"
let clamped = "use `clamp low high x`, with `import Control`"
let no_module = "the mathematical functions are built in: write `abs x`, `sqrt x`, `pi`"
let filled = "use `generate (const 0)`: its type gives the number of elements"
let fixed_size = "the size of an array is fixed; to change the element at i, write `replace i x xs`"

let of_each = function
  | "fmap" -> Some [ ("Array", "map"); ("Event", "mapE"); ("Task", "mapT") ]
  | "filter" -> Some [ ("Event", "filterEvent") ]
  | _ -> None

(* A number with or without a unit, as an argument. *)
let is_a_literal text =
  let text =
    if String.starts_with ~prefix:"(-" text && String.ends_with ~suffix:")" text then
      String.sub text 2 (String.length text - 3)
    else text
  in
  let end_ = Option.value (String.index_opt text '[') ~default:(String.length text) in
  float_of_string_opt (String.sub text 0 end_) <> None

let applied name arguments =
  match (name, arguments) with
  | ("constrain" | "clip" | "saturate" | "clampTo"), [ low; high; x ]
    when is_a_literal low && not (is_a_literal x) ->
      Some (Printf.sprintf "clamp %s %s %s" low high x, Some "Control")
  | ("constrain" | "clip" | "saturate" | "clampTo"), [ x; low; high ] ->
      Some (Printf.sprintf "clamp %s %s %s" low high x, Some "Control")
  | ("lowPassFilter" | "lowpassFilter" | "lowpass_filter" | "lowPassF" | "lpf"), [ tau; x ] ->
      Some (Printf.sprintf "lowPass %s %s" tau x, Some "Control")
  | ("highPassFilter" | "highpassFilter" | "highpass_filter" | "hpf"), [ tau; x ] ->
      Some (Printf.sprintf "highPass %s %s" tau x, Some "Filters")
  | "zip", [ xs; ys ] -> Some (Printf.sprintf "zipWith (\\x y -> (x, y)) %s %s" xs ys, None)
  | "enumerate", [ xs ] -> Some (Printf.sprintf "imap (\\i x -> (i, x)) %s" xs, None)
  | ("average" | "avg"), [ xs ] -> Some ("mean " ^ xs, None)
  | "sorted", [ xs ] -> Some ("sort " ^ xs, Some "Arrays")
  | ("foldr" | "reduce"), [ f; x; xs ] -> Some (Printf.sprintf "foldl %s %s %s" f x xs, None)
  | "product", [ xs ] -> Some ("foldl (*) 1 " ^ xs, None)
  | "minimum", [ xs ] -> Some ("minimumBy id " ^ xs, None)
  | "maximum", [ xs ] -> Some ("maximumBy id " ^ xs, None)
  | ("fromIntegral" | "fromInteger" | "float"), [ n ] -> Some ("toFloat " ^ n, None)
  | ("sq" | "square" | "sqr"), [ x ] -> Some (x ^ " ^ 2", None)
  | ("prev" | "previousValue" | "lastValue" | "unitDelay" | "memory"), [ x ] ->
      Some ("delay 0 " ^ x, None)
  | ("iPre" | "pre"), [ start; x ] -> Some (Printf.sprintf "delay %s %s" start x, None)
  | ("wrapToPi" | "wrap_angle" | "wrap_to_pi" | "normalizeAngle" | "normalize_angle"), [ a ] ->
      Some ("wrapAngle " ^ a, Some "Geometry")
  | ("rad2deg" | "degrees" | "toDegrees" | "to_degrees"), [ a ] -> Some (a ^ " / 1[deg]", None)
  | ("deg2rad" | "radians" | "toRadians" | "to_radians"), [ x ] ->
      Some ((if float_of_string_opt x = None then x ^ " * 1[deg]" else x ^ "[deg]"), None)
  | ("sleep" | "wait"), [ t ] when String.ends_with ~suffix:"s]" t ->
      Some (Printf.sprintf "sleepT %s restingOutput" t, None)
  | _ -> None

let is_an_object = function "self" | "this" -> true | _ -> false

let is_of_gains = function
  | "PID" | "Pid" | "PIDController" | "pidControl" | "pidController" | "pid_controller"
  | "pid_control" | "computePID" | "pidLoop" | "PI" | "PD" ->
      true
  | _ -> false

let number = function
  | "fromIntegral" | "fromInteger" | "realToFrac" | "float" -> Some made_into_float
  | "int" | "toInt" | "rint" | "lround" | "lroundf" | "nearbyint" -> Some made_into_int
  | "ceil" | "ceilf" -> Some "use `ceiling` to get an Int, `ceilingFloat` to get a Float"
  | "floorf" -> Some "use `floor` to get an Int, `floorFloat` to get a Float"
  | "trunc" | "truncf" -> Some "use `truncate`, which returns an Int"
  | "pow" | "powf" -> Some "write a power as `x ** y`, or as `x ^ 2` if the exponent is a literal"
  | "sq" | "square" | "sqr" -> Some "use `x ^ 2`"
  | "exp2" -> Some "use `2 ** x`"
  | "ln" -> Some "write `log`"
  | "log10" | "log2" -> Some "`log` is the natural logarithm; for base 10 write `log x / log 10`"
  | "sinh" | "cosh" | "tanh" -> Some "define it by `exp`: tanh x is `1 - 2 / (exp (2 * x) + 1)`"
  | "fabs" | "fabsf" -> Some "write `abs`"
  | "fmin" | "fminf" -> Some "write `min`"
  | "fmax" | "fmaxf" -> Some "write `max`"
  | "sgn" | "sign" -> Some "write `signum`"
  | "copysign" | "copysignf" -> Some "use `if y < 0 then -(abs x) else abs x`"
  | "fmod" | "fmodf" | "remainder" ->
      Some
        "for Floats write `x - y * floorFloat (x / y)`, which has the sign of y; for angles, \
         `wrapAngle`"
  | "rem" | "quot" | "divMod" | "quotRem" -> Some whole_division
  | "testBit" -> Some "use `x .&. shiftL 1 n /= 0`"
  | "shift" | "unsafeShiftL" | "unsafeShiftR" -> Some "use `shiftL` and `shiftR`"
  | "even" -> Some "use `mod n 2 == 0`"
  | "odd" -> Some "use `mod n 2 == 1`"
  | "constrain" | "clip" | "saturate" -> Some clamped
  | "lerp" -> Some "use `a + t * (b - a)`"
  | "nan" | "isnan" | "isNaN" -> Some "to test for NaN, write `x /= x`; to get NaN, write `0 / 0`"
  | "inf" | "isinf" | "isInfinite" | "isfinite" | "isFinite" ->
      Some "to test whether x is finite, write `x - x == 0`; for infinity write `1 / 0`"
  | "deg2rad" | "radians" | "toRadians" | "to_radians" ->
      Some "write an angle with its unit, such as `90[deg]`; for x degrees write `x * 1[deg]`"
  | "as" -> Some "to get a plain number, divide by the unit: `x / 1[deg]`"
  | "rad2deg" | "degrees" | "toDegrees" | "to_degrees" ->
      Some "to get the number of degrees, divide by the unit: `a / 1[deg]`"
  | "wrapToPi" | "wrap_angle" | "wrap_to_pi" | "normalizeAngle" | "normalize_angle" -> Some wrapped
  | "angle_diff" | "shortest_angular_distance" -> Some "use `angleDiff a b`, with `import Geometry`"
  | "math" | "np" | "numpy" -> Some no_module
  | "random" | "rand" | "randn" ->
      Some
        "use `whiteNoise 1 ()`, where 1 is the seed, with `import Sources`: each run has the same \
         noise"
  | _ -> None

let data = function
  | "null" | "nil" | "none" | "nullptr" ->
      Some
        "write `Nothing` for a missing value; the type of a value that may be missing is `Maybe a`"
  | "new" -> Some "remove `new`: a constructor alone makes a value, as in `Vec2 1[m] 2[m]`"
  | "with" -> Some "remove `with`: a copy of the record `p` with another field `x` is `p { x = 1 }`"
  | "fromJust" -> Some "use `fromMaybe x m`, where `x` replaces a missing value"
  | "isJust" | "isNothing" ->
      Some "use `maybe False (const True) m`, which is True if `m` contains a value"
  | "fmap" -> Some "use `map` for arrays, `mapE` for events, `mapT` for the results of tasks"
  | "product" -> Some "use `foldl (*) 1 xs` to multiply the elements of an array"
  | "sorted" -> Some "use `sort xs`, with `import Arrays`"
  | "sortOn" -> Some "use `sortBy key xs`, with `import Arrays`"
  | "elemIndex" -> Some "use `indexOf x xs`, with `import Arrays`"
  | "findIndex" -> Some "use `indexWhere holds xs`, with `import Arrays`"
  | "inv" -> Some "use `matInverse a`, with `import Matrix`"
  | "matmul" | "matrixMultiply" -> Some "use `matMul a b`, with `import Matrix`"
  | "average" | "avg" -> Some "use `mean xs`"
  | "minimum" -> Some "use `minimumBy id xs` for the least element of an array"
  | "maximum" -> Some "use `maximumBy id xs` for the greatest element of an array"
  | "foldr" | "reduce" -> Some "use `foldl f x xs`, which starts at the first element"
  | "filter" | "partition" | "takeWhile" | "dropWhile" ->
      Some
        "for events, use `filterEvent holds e`; the size of an array is fixed: to leave elements \
         out of a `sum`, replace them by 0 with `map (\\x -> if holds x then x else 0) xs`"
  | "zip" -> Some "use `zipWith (\\x y -> (x, y)) xs ys` to make pairs"
  | "enumerate" -> Some "use `imap (\\i x -> (i, x)) xs` to pair each element with its index"
  | "zeros" | "ones" | "replicate" -> Some filled
  | "append" | "concat" | "push_back" -> Some fixed_size
  | "len" | "sizeof" -> Some "use `length xs` for the size of an array"
  | _ -> None

let activity = function
  | "pure" -> Some "write `return`"
  | "mapM" | "mapM_" | "forM" | "forM_" | "traverse" | "traverse_" ->
      Some "to run a task for each element, write `forEachT xs f`"
  | "show" | "print" | "putStrLn" | "printf" | "disp" | "fprintf" ->
      Some
        "a program cannot print: make the value an output, and write all outputs to a file with \
         `--record`"
  | "analogRead" | "digitalRead" | "pulseIn" ->
      Some
        "a program reads pins through its input: add a field for the value to the input's type, \
         and read the field, as in `proc i -> i.light > 0.5`; a robot's sensors are signal \
         functions, such as `frontSonar i`"
  | "analogWrite" | "digitalWrite" | "tone" ->
      Some
        "a program writes pins through its output: add a field for the value to the output's type, \
         or combine commands of a robot, as in `roMake (setVelTR v omega . setLight On)`"
  | "pinMode" | "attachInterrupt" | "servo" ->
      Some "remove it: the host of the program sets up its inputs and outputs"
  | "sleep" | "usleep" | "wait" | "delayMicroseconds" ->
      Some "to wait in a task, write `sleepT 2[s] restingOutput`: the robot rests meanwhile"
  | "while" ->
      Some
        "to repeat the tasks below it, write `forever $ do` in place of this line, or, while a \
         condition holds, `whileT (proc i -> …) $ do`; to end a task when something happens, use \
         `abortWhen`"
  | "end" | "endif" | "fi" | "done" | "begin" ->
      Some "remove it: a block ends where its indentation ends"
  | "for" | "foreach" | "forEach" ->
      Some
        "to compute something for each element, write `map f xs`; to run a task for each, write \
         `forEachT xs f`"
  | "millis" | "micros" ->
      Some
        "use `time ()`, which is a time, such as `1[s]`: `after 1[s] ()` is an event that occurs \
         once, 1 s after the start, and `every 1[s] ()` one that occurs each second"
  | "localTime" -> Some "write `time`"
  | "dt" | "deltaTime" | "delta_t" ->
      Some
        "use `integral x` and `derivative x`, which need no time step; `stepTime ()` of `Control` \
         returns the time since the previous instant"
  | "assert" | "assume" ->
      Some
        "an assertion is one of the equations of a `proc`: write `proc i -> y where`, and `assert \
         \"label\" (y > 0)` in the lines below"
  | "undefined" -> Some "a program never aborts: use `Maybe` for a value that may be absent"
  | _ -> None

let signal_function = function
  | "iPre" | "pre" -> Some "use `delay x0`, where `x0` is the first value"
  | "prev" | "previousValue" | "lastValue" | "old" | "last" | "unitDelay" | "memory" ->
      Some
        "for the value one instant ago write `delay 0 x`, where 0 is the value at the first instant"
  | "pidControl" | "pidController" | "pid_controller" | "pid_control" | "computePID" | "pidLoop" ->
      Some
        "use `pid gains e`, with `import Control`, where `e` is the error and `gains` a record \
         `Pid { kp = …, ki = …, kd = …, largest = … }`"
  | "ramp" | "rampTo" | "slewRate" | "slewLimit" ->
      Some
        "use `rateLimit 0.5[m/s^2] x`, with `import Control`, to limit how fast `x` changes; it \
         starts with the first value of `x`"
  | "lowPassFilter" | "lowpassFilter" | "lowpass_filter" | "lowPassF" | "lpf" | "LPF" ->
      Some "use `lowPass tau x`, with `import Control`, where `tau` is a time constant: `0.5[s]`"
  | "highPassFilter" | "highpassFilter" | "highpass_filter" | "hpf" ->
      Some "use `highPass tau x`, with `import Filters`, where `tau` is a time constant: `0.5[s]`"
  | "medianFilter" | "medfilt" | "medfilt1" | "median_filter" ->
      Some "use `median (recent 5 x)`, with `import Filters`"
  | "integrate" | "cumtrapz" -> Some "write `integral`"
  | "deriv" | "differentiate" -> Some "write `derivative`"
  | "until" | "untilB" ->
      Some
        "to run another signal function after an event, use `switch`; to end a task at an event, \
         write ``t `abortWhen` sf``"
  | "repeatedly" -> Some "use `every q`, whose events carry `()`"
  | "filterE" -> Some "write `filterEvent`"
  | "lMerge" -> Some "write `mergeE`"
  | "rMerge" -> Some "write `mergeR`"
  | "joinE" | "pairE" -> Some "write `pairEvents`"
  | "iEdge" -> Some "write `edgeFrom`"
  | "attach" -> Some "use `snapshot` on event signals"
  | "par" | "parA" ->
      Some
        "use `parB sfs` to run an array of signal functions on one input, `parZ sfs` to run each \
         on its own input"
  | "reactimate" ->
      Some
        "use `reactimateRobot` to turn a signal function into a robot program; `frobc trace` runs \
         any other signal function directly"
  | _ -> None

let reading = function
  | "speed" | "vel" | "velX" | "getVelocity" | "getSpeed" -> Some (format_of_string "velocity %s")
  | "range" | "distance" | "dist" | "sonarDistance" | "readSonar" | "ranger" ->
      Some (format_of_string "frontSonar %s")
  | "angle" | "direction" | "theta" | "heading" | "yaw" | "orientation" ->
      Some (format_of_string "(robotPose %s).heading")
  | "gyro" | "angularVelocity" | "turnSpeed" | "rotation" | "yawRate" ->
      Some (format_of_string "turnRate %s")
  | "position" -> Some (format_of_string "place %s")
  | "battery" | "batteryLevel" | "voltage" | "getBattery" ->
      Some (format_of_string "batteryVoltage %s")
  | "bump" | "bumper" | "collision" | "isBumped" -> Some (format_of_string "bumped %s")
  | _ -> None

let current name =
  let n = String.length name in
  let without_end suffix =
    if String.ends_with ~suffix name && n > String.length suffix then
      Some (String.sub name 0 (n - String.length suffix))
    else None
  in
  let without_start prefix =
    let k = String.length prefix in
    if String.starts_with ~prefix name && n > k then
      Some (String.uncapitalize_ascii (String.sub name k (n - k)))
    else None
  in
  List.filter_map without_end
    [ "_prev"; "_old"; "_last"; "_previous"; "Prev"; "Old"; "Last"; "Previous" ]
  @ List.filter_map without_start
      [ "prev_"; "old_"; "last_"; "previous_"; "prev"; "old"; "last"; "previous" ]

let is_of_speed = function
  | "setSpeed" | "setVelocity" | "set_velocity" | "setVel" | "setMotors" | "setMotorSpeed"
  | "cmd_vel" | "cmdVel" | "drive" ->
      true
  | _ -> false

let robot = function
  | "heading" | "theta" | "yaw" | "orientation" | "compass" ->
      Some "use `(robotPose i).heading` for the direction in which the robot faces"
  | "pose" | "odom" | "odometry" | "position" | "getPose" | "get_pose" ->
      Some
        "for the robot's position write `place i`, with the fields `x` and `y`, or `robotPose i`, \
         with `position` and `heading`"
  | "sonar" | "sonarFront" | "front_sonar" | "ultrasonic" | "laser" | "lidar" | "frontDistance"
  | "getDistance" | "get_distance" | "ping" ->
      Some
        "for the distance ahead write `frontSonar i`; to the left, `sideSonar i`; to the right, \
         `rightSonar i`"
  | "leftSonar" | "sonarLeft" | "left_sonar" ->
      Some "use `sideSonar i` for the distance to the left"
  | "sonarRight" | "right_sonar" -> Some "use `rightSonar i` for the distance to the right"
  | "bump" | "bumper" | "isBumped" | "bumperPressed" ->
      Some "use `bumped i`, which is True while the robot touches something"
  | "setSpeed" | "setVelocity" | "set_velocity" | "setVel" | "setMotors" | "setMotorSpeed"
  | "cmd_vel" | "cmdVel" | "publish" | "drive" | "motor" | "motors" ->
      Some "use `roMake (setVelTR v omega)` for a robot's output: its speed and its turn rate"
  | "turnLeft" | "turn_left" | "turnRight" | "turn_right" | "turn" ->
      Some "to turn on the spot in a task, write `turnBy 90[deg]`; a positive angle turns left"
  | "moveForward" | "move_forward" | "driveForward" | "goForward" | "move" | "driveStraight" ->
      Some "to drive straight ahead in a task, write `forward 1[m]`"
  | "red" | "green" | "blue" | "yellow" | "orange" ->
      Some
        "describe a colour for the camera as a range: `ColourRange { hueFrom = 340[deg], hueTo = \
         20[deg], … }`, with `import Vision`"
  | "stop" | "halt" | "stopMotors" ->
      Some
        "use `restingOutput` for a robot at rest; in a task, `sleepT 1[s] restingOutput` rests for \
         a time"
  | _ -> None

let value name = List.find_map (fun hint -> hint name) [ number; data; activity; signal_function ]

let is_statement = function
  | "while" | "for" | "foreach" | "print" | "printf" | "disp" | "fprintf" -> true
  | _ -> false

let constructor = function
  | "None" | "Null" | "NULL" -> Some "write `Nothing`"
  | "Some" -> Some "write `Just`"
  | "Twist" -> Some "set a robot's speed and turn rate by `setVelTR v omega`"
  | "TRUE" | "HIGH" | "ON" -> Some "write `True`"
  | "FALSE" | "LOW" | "OFF" -> Some "write `False`"
  | "PI" | "M_PI" -> Some "write `pi`"
  | "TWO_PI" | "TAU" -> Some "use `2 * pi`"
  | "HALF_PI" | "M_PI_2" -> Some "use `pi / 2`"
  | "NAN" | "NaN" -> Some "use `0 / 0` for NaN"
  | "INFINITY" | "Infinity" -> Some "use `1 / 0` for infinity"
  | _ -> None

let qualifier = function
  | "Math" | "Maths" | "Numeric" -> Some no_module
  | "Time" | "Clock" -> Some "time is built in: write `time ()` for the time since the start"
  | "List" | "Array" | "Vector" -> Some "arrays are built in: write `map f xs`, `foldl (+) 0 xs`"
  | "Random" -> Some "for random numbers write `whiteNoise 1 ()`, with `import Sources`"
  | _ -> None

(* The library module that corresponds to a module of another language or robot. *)
let in_library = function
  | "Sonar" | "Sonars" | "Ultrasonic" | "Distance" | "Range" -> Some ("the sonars are", "Robot")
  | "Sensor" | "Sensors" | "Bumper" | "Bumpers" | "Odometry" -> Some ("the sensors are", "Robot")
  | "Motor" | "Motors" | "Wheels" | "DiffDrive" | "Velocity" ->
      Some ("the commands for the motors are", "Robot")
  | "Laser" | "LaserScan" | "Scan" | "Scanner" -> Some ("laser scanners are", "Lidar")
  | "Camera" | "OpenCV" | "Cv" | "Cv2" | "Image" | "Images" -> Some ("cameras are", "Vision")
  | "Tf" | "Tf2" | "Transform" | "Transforms" | "Pose" | "Point" ->
      Some ("poses and points are", "Geometry")
  | "Rclpy" | "Rospy" | "Rclcpp" | "Roscpp" | "Ros2" | "GeometryMsgs" | "SensorMsgs" ->
      Some ("the robots of ROS 2 are", "Ros")
  | "Numpy" | "Scipy" | "LinearAlgebra" | "Eigen" -> Some ("matrices are", "Matrix")
  | "Filter" | "LowPass" | "Smoothing" -> Some ("filters are", "Control")
  | "Noise" | "Signals" -> Some ("sources of signals are", "Sources")
  | _ -> None

let module_ = function
  | "Event" | "Events" | "Task" | "Tasks" | "Switch" | "Yampa" | "Frp" | "FRP" | "Arrow" ->
      Some "remove this line: events, tasks and `switch` are built in"
  | "Units" | "Unit" | "Si" | "SI" -> Some "remove this line: units are built in, as in `0.3[m/s]`"
  | "Math" | "Maths" | "Numeric" ->
      Some "remove this line: mathematical functions are built in, as in `sin x` and `sqrt x`"
  | "Time" | "Clock" ->
      Some
        "remove this line: time is built in; write `time ()` for the time since the start of the \
         program"
  | "List" | "Array" | "Vector" ->
      Some "remove this line: arrays are built in, as in `map f xs` and `foldl (+) 0 xs`"
  | "Random" ->
      Some "write `import Sources` instead; `whiteNoise 1 ()` returns random numbers, with seed 1"
  | _ -> None

let type_ = function
  | "IO" ->
      Some "give `main` the type `Program RobotInput RobotOutput`, or make it a signal function"
  | "Str" | "Char" | "Text" | "CString" ->
      Some "the type of text is `String`; text is only used for labels"
  | "List" | "Vector" | "Vec" -> Some "use an array for several values of one type: `Array 4 Float`"
  | "Number" | "Real" | "Num" | "Decimal" | "Rational" -> Some "use `Float` or `Int` for numbers"
  | "Optional" | "Option" -> Some "use `Maybe` for a value that may be missing"
  | "Duration" | "Seconds" -> Some "write `Time`"
  | "Boolean" | "BOOL" | "Logical" -> Some "write `Bool`"
  | "Integer" | "Int32" | "Long" -> Some "write `Int`"
  | "Speed" -> Some "write `Velocity`"
  | "Length" -> Some "write `Distance`"
  | "Twist" -> Some "set a robot's speed and turn rate by `setVelTR v omega`"
  | "Signal" | "Behavior" | "Behaviour" ->
      Some
        "variables of a `proc` are already signals: write the type of the values, such as `Float`"
  | _ -> None

let class_ = function
  | "Num" | "Fractional" | "Floating" | "Real" | "Integral" | "RealFrac" ->
      Some
        "there are no classes of numbers: write `n[u]` for a number of any kind and unit, as in \
         `twice :: n[u] -> n[u]`, or `Float[u]` for a number with fractions"
  | "Show" | "Read" -> Some "remove it: a trace can show values of every type"
  | "Functor" | "Applicative" | "Monad" | "Foldable" | "Traversable" | "Semigroup" | "Monoid" ->
      Some "remove it: Frob has no classes of type constructors"
  | "Enum" | "Bounded" -> Some "write a `case` that gives each constructor its number"
  | _ -> None
