Words and notations of other languages together with their arguments: the hint contains the whole
line in Frob. Each program is given by its lines; the test shows the hints, and checks the program
with the lines that the hint suggests.

  $ try () { # PROGRAM CORRECTED-PROGRAM
  >   printf "$1"'\n' > program.frob
  >   frobc check program.frob 2>&1 | grep '^error\|hint'
  >   printf "$2"'\n' > corrected.frob; frobc check corrected.frob 2>&1 | grep '^error'
  > }

A function whose name depends on the container:

  $ M='main :: SF (Event Float) (Event Float)\nmain = proc e ->'
  $ try "$M fmap (2 *) e" "$M mapE (2 *) e"
  error[E0205]: unknown name `fmap`
    = hint: write `mapE`
  [1]
  $ try "$M filter (> 3) e" "$M filterEvent (> 3) e"
  error[E0205]: unknown name `filter`
    = hint: write `filterEvent`
  [1]
  $ M='import Arrays\nmain :: SF (Array 3 Float) Int\nmain = proc xs ->'
  $ try "$M length (filter (> 3) xs)" "$M countWhere (> 3) xs"
  error[E0205]: unknown name `filter`
    = hint: write `countWhere (> 3) xs`
  [1]

Constants of a module, units and signs:

  $ M='f :: Float -> Float\nf x ='
  $ try "$M sin (2 * math.pi * x)" "$M sin (2 * pi * x)"
  error[E0205]: unknown name `math`
    = hint: write `pi`, without `math.`
  [1]
  $ try "$M x * 50[%%]" "$M x * 0.5"
  error[E0103]: unexpected character `%`
    = hint: percent is not a unit: write `0.5`
  [1]
  $ M='f :: Velocity -> Bool\nf v = v >'
  $ try "$M 20[km/h]" "$M 20[km/hour]"
  error[E0208]: unknown unit `h`
    = hint: the unit is `hour`: write `20[km/hour]`
  [1]
  $ try '#include <Robot.h>\nf :: Float\nf = 1' 'import Robot\nf :: Float\nf = 1'
  error[E0103]: unexpected character `#`
    = hint: write `import Robot`
  [1]

A controller with its gains as arguments, by a name or as the function of the library:

  $ M='import Control\nf :: SF Float Float\nf = proc e ->'
  $ try "$M PID 0.5 0.1 0 e" "$M pid (Pid { kp = 0.5, ki = 0.1[1/s], kd = 0, largest = 1 }) e"
  error[E0206]: unknown constructor `PID`
    = hint: use `pid (Pid { kp = 0.5, ki = 0.1, kd = 0, largest = … }) e`
  [1]
  $ try "$M pid 0.5 0.1 0 e" "$M pid (Pid { kp = 0.5, ki = 0.1[1/s], kd = 0, largest = 1 }) e"
  error[E0301]: expected `Pid[u, v]`, found `Float`
    = hint: `pid` takes a single record, not separate numbers: write `pid (Pid { kp = 0.5, ki = 0.1, kd = 0, largest = … }) e`
  [1]

The body of a function, a branch, and comparisons:

  $ try 'square(x) {\n    return x * x;\n}' 'square x = x * x'
  error[E0110]: this function definition is not valid Frob syntax
    = hint: define a function by an equation: `square x = x * x`
  [1]
  $ M='data Mode = Idle | Go\nf :: Mode -> Float\nf m = case m of\n    Go -> 1\n'
  $ try "$M    Idle => 0" "$M    Idle -> 0"
  error[E0110]: expected an operator, an argument, or the end of the expression, found `=>`
    = hint: use `->` in a branch: `Idle -> 0`
  [1]
  $ M='f :: Distance -> Bool\nf d ='
  $ try "$M 0.2[m] < d < 0.8[m]" "$M 0.2[m] < d && d < 0.8[m]"
  error[E0113]: `<` and `<` cannot be combined without parentheses
    = hint: compare two values at a time: `0.2[m] < d && d < 0.8[m]`
  [1]

Loops, choices and times in the `do` of a task:

  $ M='import Robot\ngo :: (HasSonar i, DiffDrive o) => Task i o ()\ngo = do\n    ok <- forward 1[m]\n'
  $ try "$M    for k in 1 to 4 do\n        turnBy 90[deg]" "$M    repeatT 4 \$ do\n        turnBy 90[deg]"
  error[E0110]: Frob has no `for`
    = hint: to run the tasks of this block 4 times, write `repeatT 4 $ do` in place of this line
  [1]
  $ try "$M    if not ok then\n        turnBy 90[deg]\n        forward 1[m]\n    return ()" "$M    whenT (not ok) \$ do\n        turnBy 90[deg]\n        forward 1[m]\n    return ()"
  error[E0110]: expected `else` after the first branch, found the end of the statement
    = hint: to run these tasks only if the condition holds, replace the `if` line with `whenT (not ok) $ do`; to choose between two blocks of tasks, add an `else`
  [1]
  $ try "$M    repeatT (turnBy 90[deg])" "$M    repeatT 4 (turnBy 90[deg])"
  error[E0301]: expected `Int`, found `Task a b Bool`
    = hint: the number of times comes first: write `repeatT 4 (…)`; to repeat endlessly, use `forever`
  [1]

Choices between commands have one message:

  $ try "$M    if ok then setVelTR 0 0 else setVelTR 1[m/s] 0" "$M    if ok then sleepT 1[s] (roMake (setVelTR 0 0)) else sleepT 1[s] (roMake (setVelTR 1[m/s] 0))"
  error[E0370]: each statement in a `do` must be a task, but this is `a -> a`
    = hint: use `sleepT 1[s] (roMake (setVelTR 0 0))` for a task of one second, or `constT (roMake (setVelTR 0 0))` for one that never ends
  [1]

The words of a name in another order, and a field by its quantity:

  $ M='import Control\nf :: SF Float Float\nf = proc x ->'
  $ try "$M passLow 0.5[s] x" "$M lowPass 0.5[s] x"
  error[E0205]: unknown name `passLow`
    = hint: did you mean `lowPass`?
  [1]
  $ try 'data R = R { range :: Distance, angle :: Angle }\nf :: R -> Distance\nf r = r.distance' 'data R = R { range :: Distance, angle :: Angle }\nf :: R -> Distance\nf r = r.range'
  error[E0310]: `R` has no field `distance`
    = hint: did you mean `range`?
  [1]
