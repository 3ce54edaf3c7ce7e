Equations that read their own value, and the order of the arguments of `delay`: the hint contains
the equation with the earlier value. A choice reads it from an equation of its own.

  $ try () { # SIGNATURE EQUATIONS CORRECTED-EQUATIONS
  >   printf 'main :: %s\nmain = proc x -> y where\n%s\n' "$1" "$2" > program.frob
  >   frobc check program.frob 2>&1 | grep '^error\|hint'
  >   printf 'main :: %s\nmain = proc x -> y where\n%s\n' "$1" "$3" > corrected.frob; frobc check corrected.frob 2>&1 | grep '^error'
  > }

  $ try 'SF Velocity Distance' '    y = y + x * 0.02[s]' '    y = integral x'
  error[E0401]: the signal `y` needs its own value in the same instant
    = hint: for the sum over time, write `y = integral x`
  [1]
  $ try 'SF Velocity Distance' '    y = y + x * dt' '    y = integral x'
  error[E0205]: unknown name `dt`
    = hint: for the sum over time, write `y = integral x`, which needs no time step
  [1]
  $ try 'SF Velocity Distance' '    y = y - 20[ms] * x' '    y = -integral x'
  error[E0401]: the signal `y` needs its own value in the same instant
    = hint: for the sum over time, write `y = -integral x`
  [1]
  $ try 'SF Float Float' '    y = 0.9 * y + 0.1 * x' '    y = 0.9 * delay 0 y + 0.1 * x'
  error[E0401]: the signal `y` needs its own value in the same instant
    = hint: let `y` read its own previous value: write `y = 0.9 * delay 0 y + 0.1 * x`, where 0 is the initial value
  [1]
  $ try 'SF Float Float' '    y = max y x' '    y = max (delay 0 y) x'
  error[E0401]: the signal `y` needs its own value in the same instant
    = hint: let `y` read its own previous value: write `y = max (delay 0 y) x`, where 0 is the initial value
  [1]
  $ try 'SF Bool Int' '    y = if x then y + 1 else y' '    before = delay 0 y
  >     y = if x then before + 1 else before'
  error[E0401]: the signal `y` needs its own value in the same instant
    = hint: let `y` read its own previous value: write `before = delay 0 y` and `y = if x then before + 1 else before`, where 0 is the initial value
  [1]
  $ try 'SF Float Float' '    y = x - 0.1 * z
  >     z = 2 * y' '    y = x - 0.1 * z
  >     z = 2 * delay 0 y'
  error[E0401]: the signal `y` needs its own value in the same instant
    = hint: let `z` read the previous value of `y`: write `z = 2 * delay 0 y`, where 0 is the initial value
  [1]

If the equation continues on the next line, the previous value is an equation to add:

  $ try 'SF Float Float' '    y = 0.9 * y +
  >         0.1 * x' '    before = delay 0 y
  >     y = 0.9 * before +
  >         0.1 * x'
  error[E0401]: the signal `y` needs its own value in the same instant
    = hint: let `y` read its own previous value: add the equation `before = delay 0 y`, where 0 is the initial value, and read `before` here
  [1]

The order of the arguments:

  $ try 'SF Bool Bool' '    y = delay x False' '    y = delay False x'
  error[E0340]: the initial value of `delay` must be static, but `x` is a signal
    = hint: the initial value comes before the signal: write `delay False x`
  [1]

An event as a condition:

  $ try 'SF Bool Float' '    y = if edge x then 1 else 0' '    y = if x then 1 else 0'
  error[E0301]: a condition must be `Bool`, but this is `Event ()`
    = hint: to test whether the condition is True, write `x`; to test whether it becomes True in this instant, write `isEvent (edge x)`
  [1]
  $ try 'SF Bool Bool' '    y = hold False (edge x)' '    y = hold False (tag (edge x) True)'
  error[E0301]: expected `Event Bool`, found `Event ()`
    = hint: the value of this event is `()`: for the value True, write `tag (edge x) True`
  [1]
