Calls with the arguments, the names or the operators of other languages, where the first hint used
to lead astray. Each program is one line under a signature; the test shows the message without the
source, and checks the line with which the hint replaces it.

  $ try () { # SIGNATURE LINE CORRECTED-LINE
  >   printf 'import Control\nimport Logic\nimport Matrix\nf :: %s\n%s\n' "$1" "$2" > program.frob
  >   frobc check program.frob 2>&1 | grep -v 'W0306\|: remove it$' | grep '^error\|^warning\|hint'
  >   printf 'import Control\nimport Logic\nimport Matrix\nf :: %s\n%s\n' "$1" "$3" > corrected.frob
  >   frobc check corrected.frob 2>&1 | grep '^error\|W0316'
  > }

  $ try 'Array 8 Distance -> Int' 'f ds = foldl (\d n -> if d < 0.5[m] then n + 1 else n) 0 ds' 'f ds = foldl (\n d -> if d < 0.5[m] then n + 1 else n) 0 ds'
  error[E0301]: the parameters of this function are in the wrong order
    = hint: write `\n d -> …`
  [1]

  $ try 'Distance -> Distance' 'f x = saturate 0 0.4[m] (2 * x)' 'f x = clamp 0 0.4[m] (2 * x)'
  error[E0205]: unknown name `saturate`
    = hint: write `clamp 0 0.4[m] (2 * x)`
  [1]

  $ try 'Distance -> Distance' 'f x = constrain (2 * x) 0 0.4[m]' 'f x = clamp 0 0.4[m] (2 * x)'
  error[E0205]: unknown name `constrain`
    = hint: write `clamp 0 0.4[m] (2 * x)`
  [1]

  $ try 'SF (Bool, Bool) Bool' 'f = proc (on, off) -> latch (on, off)' 'f = proc (on, off) -> latch ResetWins (on, off)'
  error[E0301]: expected `Wins`, found a tuple with 2 elements
    = hint: say what happens if both are True: write `latch ResetWins (on, off)` or `latch SetWins (on, off)`
  [1]

  $ try 'Matrix 2 2 -> Matrix 2 2' 'f a = matMul a a'\''' 'f a = matMul a (transpose a)'
  error[E0205]: unknown name `a'`
    = hint: `'` is part of the name: for the transpose of `a`, write `(transpose a)`
  [1]

  $ try 'Matrix 1 2 -> Vector 2 -> Vector 1' 'f a x = a * x' 'f a x = matVec a x'
  error[E0301]: expected a number, found `Matrix 1 2`
    = hint: to multiply a matrix by a vector, write `matVec a x`
  [1]

  $ try 'Matrix 1 2 -> Matrix 2 3 -> Matrix 1 3' 'f a b = a * b' 'f a b = matMul a b'
  error[E0301]: expected a number, found `Matrix 1 2`
    = hint: to multiply a matrix by a matrix, write `matMul a b`
  [1]

  $ try 'Array 5 Angle' 'f = map (\k -> k * 30[deg]) (1:5)' 'f = map (\k -> k * 30[deg]) [1, 2, 3, 4, 5]'
  error[E0103]: unexpected character `:`
    = hint: Frob has no ranges: write the elements, `[1, 2, 3, 4, 5]`
  [1]

  $ try 'Float -> Float' 'f x = map x 0 1023 0 255' 'f x = x / 1023 * 255'
  error[E0301]: `map` applies a function to each element of an array
    = hint: to convert a number from one range to another, write `x * 255 / 1023`
  [1]

  $ try 'SF Float Float' 'f = proc x -> max 1 (min (-1) x)' 'f = proc x -> max (-1) (min 1 x)'
  warning[W0316]: the lower limit is above the upper one, so the result is always this limit
    = hint: swap the two limits
  [1]

  $ try 'SF Float Float' 'f = proc x -> min (-1) (max x 1)' 'f = proc x -> min 1 (max x (-1))'
  warning[W0316]: the lower limit is above the upper one, so the result is always this limit
    = hint: swap the two limits
  [1]

  $ try 'SF Float Float' 'f = proc x -> clamp x 0 1' 'f = proc x -> clamp 0 1 x'
  warning[W0316]: this is the lower limit of `clamp`, and the value being limited is a constant
    = hint: write the limits first: `clamp low high x`
  [1]

  $ try 'Pid[1, 1/s]' 'f = Pid { kp = 2[1/s], ki = 0.3[1/s], kd = 0.1, largest = 60[deg/s] }' 'f = Pid { kp = 2[1/s], ki = 0.3[1/s^2], kd = 0.1, largest = 60[deg/s] }'
  error[E0320]: expected the unit `1/s^2`, found `1/s`
    = hint: give all numbers in the record their units: for a `Pid[1, 1/s]` (u is `1`, v is `1/s`), write `Pid { kp = 2[1/s], ki = 0.3[1/s^2], kd = 0.1, largest = 60[deg/s] }`
  [1]

A name with a hyphen:

  $ printf 'top-speed :: Float\ntop-speed = 0.6\nmain :: SF Float Float\nmain = proc x -> x\n' > hyphen.frob
  $ frobc check hyphen.frob 2>&1 | grep '^error\|hint'
  error[E0110]: expected `=` after the left-hand side of a definition, found `::`
    = hint: a name cannot contain `-`: write `topSpeed`
  error[E0114]: a name cannot contain `-`
    = hint: write `topSpeed`

Robots, tasks and trials:

  $ try () { # SIGNATURE LINE CORRECTED-LINE
  >   printf 'import Past\nimport Robot\nimport Trial\nf :: %s\n%b\n' "$1" "$2" > program.frob
  >   frobc check program.frob 2>&1 | grep -v 'W0306\|: remove it$' | grep '^error\|^warning\|hint'
  >   printf 'import Past\nimport Robot\nimport Trial\nf :: %s\n%b\n' "$1" "$3" > corrected.frob
  >   frobc check corrected.frob 2>&1 | grep '^error\|W0318'
  > }

  $ try 'RobotOutput' 'f = roMake (setVelTR 40[rpm] 0)' 'f = roMake (setVelTR (40[rpm] * 0.05[m]) 0)'
  error[E0320]: expected the unit `m/s`, found `1/s`
    = hint: if this is the speed of a wheel, multiply it by the radius of the wheel, as in `(40[rpm] * 0.05[m])`; if it is the turn rate, pass it as the second argument
  [1]

  $ try 'SF Truth Verdict' 'f = neverTouches && endsWithin 15[s]' 'f = bothOf neverTouches (endsWithin 15[s])'
  error[E0301]: expected `Bool`, found `SF Truth Verdict`
    = hint: to require two verdicts, write `bothOf neverTouches (endsWithin 15[s])`
  [1]

  $ try 'Bool -> Bool -> Verdict' 'f near stops = near implies stops' 'f near stops = near `implies` stops'
  error[E0302]: `near` is `Bool`, not a function
    = hint: to write a function between its arguments, put it in backticks: ``near `implies` …``
  [1]

  $ try 'Program RobotInput RobotOutput' 'f = watching (forward 1[m])' 'f = reactimateTask (watching (forward 1[m]))'
  error[E0301]: expected `Program RobotInput RobotOutput`, found `Task a b Bool`
    = hint: to turn the task into a program, write `reactimateTask (watching (forward 1[m]))`
  [1]

  $ try '(DiffDrive o, HasSonar i) => SF i o -> Task i o ()' 'f _ = mkTask cruise\n\ncruise :: DiffDrive o => SF i o\ncruise = proc _ -> roMake (setVelTR 0.2[m/s] 0)' 'f _ = mkTask (cruise &&& after 10[s])\n\ncruise :: DiffDrive o => SF i o\ncruise = proc _ -> roMake (setVelTR 0.2[m/s] 0)'
  error[E0360]: there is no instance `DiffDrive (o, Event ())`
    = hint: `mkTask` needs the output and an event that ends the task: write `mkTask (cruise &&& after 10[s])`, or use another event
  [1]

  $ try '(DiffDrive o, HasSonar i) => Task i o Bool' 'f = do\n    forever (forward 1[m])\n    turnBy 90[deg]' 'f = do\n    repeatT 4 (forward 1[m])\n    turnBy 90[deg]'
  warning[W0318]: this statement is never reached
    = hint: remove the statements after the task, or end the task with ``t `timeOut` 30[s]`` or with `abortWhen` and an event
  [1]

  $ try '(DiffDrive o, HasSonar i) => Task i o Bool' 'f = do\n    forever $ do\n        forward 1[m]\n    turnBy 90[deg]' 'f = do\n    forever (forward 1[m]) `timeOut` 30[s]\n    turnBy 90[deg]'
  warning[W0318]: this statement is never reached
    = hint: remove the statements after the task, or end the task with ``t `timeOut` 30[s]`` or with `abortWhen` and an event
  [1]


Notations of other languages:

  $ check () { # PROGRAM
  >   printf "$1" > program.frob; frobc check program.frob 2>&1 | grep '^error\|hint'
  > }
  $ check 'mask :: Int -> Int\nmask pin = 1 << pin\n'
  error[E0110]: Frob has no `<<`
    = hint: to shift the bits of an Int, write `shiftL 1 pin`
  $ check 'total :: Float -> Float -> Float\ntotal x y = x + ...\n    y\n'
  error[E0110]: expected an operand after the operator, found `.`
    = hint: remove `...`: an indented line continues the line above
  $ check 'heat :: Float -> Float\nheat a = 4 * a .^ 2\n'
  error[E0110]: Frob has no `.^`
    = hint: operators take numbers, not arrays: write `a ^ 2` for numbers, or `map (\x -> x ^ 2) a` for arrays
  $ check 'speed :: Int -> Float\nspeed key = case key of\n    119 -> 0.4\n    else -> 0\n'
  error[E0110]: expected a branch of the `case`, found `else`
    = hint: to match all other values, write `_` instead of `else`
  $ check 'import Robot\nmain :: HasSonar i => DiffDrive o => Program i o\nmain = f\n'
  error[E0110]: expected `->` or the end of this type, found `=>`
    = hint: write one context: `(HasSonar i, DiffDrive o) =>`

  $ try 'SF (Bool, Velocity) Velocity' 'f = proc (hit, v) -> if n < 3 then v else 0 where n = count (edge hit)' \
  >   'f = proc (hit, v) -> if hold 0 n < 3 then v else 0 where n = count (edge hit)'
  error[E0301]: expected a number, found `Event Int`
    = hint: an event has a value only when it occurs: write `hold 0 n` for its latest value, which is 0 at first
  [1]

  $ try 'SF Bool Time' 'f = proc pressed -> resetOn time (edge pressed)' 'f = proc pressed -> resetOn time ((), edge pressed)'
  error[E0301]: expected `(a, Event ())`, found `Event ()`
    = hint: pass the input and the event as a pair: `resetOn time ((), edge pressed)`
  [1]

  $ try 'SF (Velocity, Bool) Distance' 'f = proc (v, b) -> resetOn integral (edge b)' 'f = proc (v, b) -> resetOn integral (v, edge b)'
  error[E0301]: expected `(Float[u], Event ())`, found `Event ()`
    = hint: pass the input and the event as a pair: `resetOn integral (v, edge b)`
  [1]

  $ try 'Velocity -> Velocity' 'f v = return max (-0.5[m/s]) (min 0.5[m/s] v)' 'f v = max (-0.5[m/s]) (min 0.5[m/s] v)'
  error[E0301]: `return` is only for tasks
    = hint: write `f v = max (-0.5[m/s]) (min 0.5[m/s] v)`
  [1]

  $ try 'SF Velocity Distance' 'f = proc v -> way where way = return (integral v)' 'f = proc v -> way where way = integral v'
  error[E0301]: `return` is only for tasks
    = hint: write `f = proc v -> way where way = integral v`
  [1]
