Values, tasks and units written as in other languages, each with the program that the message
suggests.

  $ try () { # PROGRAM CORRECTED
  >   printf "import Control\nimport Geometry\nimport Robot\nimport Trial\n$1\n" > program.frob
  >   frobc check program.frob 2>&1 | grep '^error\|hint'
  >   printf "import Control\nimport Geometry\nimport Robot\nimport Trial\n$2\n" > corrected.frob
  >   frobc check corrected.frob 2>&1 | grep '^error'
  > }

A value after `return`:

  $ try 'near d e = return d < e' 'near d e = d < e'
  error[E0301]: `return` is only for tasks
    = hint: write `near d e = d < e`
  [1]
  $ try 'half :: Float -> Float\nhalf x = return (x / 2)' 'half :: Float -> Float\nhalf x = x / 2'
  error[E0301]: `return` is only for tasks
    = hint: write `half x = x / 2`
  [1]
  $ try 'limited :: Float -> Float\nlimited v = return max (-1) v' 'limited :: Float -> Float\nlimited v = max (-1) v'
  error[E0301]: `return` is only for tasks
    = hint: write `limited v = max (-1) v`
  [1]
  $ try 'f :: SF Velocity Distance\nf = proc v -> 2 * way where\n    way = return (integral v)' 'f :: SF Velocity Distance\nf = proc v -> 2 * way where\n    way = integral v'
  error[E0301]: `return` is only for tasks
    = hint: write `way = integral v`
  [1]

In a task, `return` is right, and only its argument needs parentheses:

  $ try 'f :: Task i o Float\nf = do\n    return max 1 2' 'f :: Task i o Float\nf = do\n    return (max 1 2)'
  error[E0302]: `return` takes 1 argument, but is given 3
    = hint: put parentheses around the argument: `return (max 1 2)`
  [1]
  $ try 'f :: Task i o Bool\nf = return 1' 'f :: Task i o Bool\nf = return True'
  error[E0301]: expected a task that returns `Bool`, but this one returns a number
    = hint: to apply a function `f` to the result of a task `t`, write `mapT f t`
  [1]

Types before the names of parameters:

  $ try 'half Float x = x / 2' 'half x = x / 2'
  error[E0206]: a parameter cannot have a type
    = hint: write `half x = x / 2`, and put the types in a signature above it: `half :: Float -> …`
  [1]
  $ try 'Float half(Float x) = x / 2' 'half :: Float -> Float\nhalf x = x / 2'
  error[E0226]: a top-level definition defines one name, not a pattern
    = hint: write the types in a signature, `half :: Float -> Float`, and the definition below it, `half x = …`
  [1]
  $ try 'f xs = foldl (\\Float a Float b -> a + b) 0 xs' 'f xs = foldl (\\a b -> a + b) 0 xs'
  error[E0206]: a parameter cannot have a type
    = hint: write `\a b ->`, without types
  [1]
  $ try 'half = Float x -> x / 2' 'half = \\x -> x / 2'
  error[E0110]: expected an operator, an argument, or the end of this definition, found `->`
    = hint: write an anonymous function as `\x -> x / 2`, or a signal function as `proc x -> …`
  [1]
  $ try 'f = proc Float x -> x / 2' 'f = proc x -> x / 2'
  error[E0110]: expected `->` after the input of this `proc`, found `x`
    = hint: write the input without its type: `proc x -> …`
  [1]
  $ try 'f = \\(x :: Float) -> x / 2' 'f = \\x -> x / 2'
  error[E0114]: a type cannot be part of a pattern
    = hint: write `x` alone; types belong in a signature, on the line above a definition
  [1]
  $ try 'f = \\x => x + 1' 'f = \\x -> x + 1'
  error[E0110]: expected an operator, an argument, or the end of the expression, found `=>`
    = hint: write `->` between the parameters of a function and its result
  [1]
  $ try 'f :: SF Float Float\nf = proc x => x + 1' 'f :: SF Float Float\nf = proc x -> x + 1'
  error[E0110]: expected an operator, an argument, or the end of the expression, found `=>`
    = hint: write `->` after the input of a `proc`: `proc x ->`
  [1]
  $ try 'f :: Float m/s -> Time -> Distance\nf v t = v * t' 'f :: Float[m/s] -> Time -> Distance\nf v t = v * t'
  error[E0110]: expected `->` or the end of the type after a type variable, found `/`
    = hint: a unit in a type needs brackets: `Float[m/s]`
  [1]
  $ try 'f :: Float m -> Distance\nf x = x' 'f :: Float[m] -> Distance\nf x = x'
  error[E0216]: type `Float` takes 0 type arguments, not 1
    = hint: a unit in a type needs brackets: `Float[m]`
  [1]

An initial value, or a length of the step, of `integral` and `derivative`:

  $ try 'f :: SF Velocity Distance\nf = proc v -> integral 0 v' 'f :: SF Velocity Distance\nf = proc v -> integral v'
  error[E0302]: `integral` takes 1 argument, but is given 2
    = hint: remove the `0`, because `integral` starts at 0 anyway: write `integral v`
  [1]
  $ try 'f :: SF Velocity Distance\nf = proc v -> integral v 0' 'f :: SF Velocity Distance\nf = proc v -> integral v'
  error[E0302]: `integral` takes 1 argument, but is given 2
    = hint: remove the `0`, because `integral` starts at 0 anyway: write `integral v`
  [1]
  $ try 'f :: SF Velocity Distance\nf = proc v -> integral(v, 0)' 'f :: SF Velocity Distance\nf = proc v -> integral v'
  error[E0301]: expected `Float[u]`, found a tuple with 2 elements
    = hint: `integral` takes one argument and starts at 0: write `integral v`
  [1]
  $ try 'f :: SF Velocity Acceleration\nf = proc v -> derivative 0 v' 'f :: SF Velocity Acceleration\nf = proc v -> derivative v'
  error[E0302]: `derivative` takes 1 argument, but is given 2
    = hint: remove the `0`, because `derivative` starts at 0 anyway: write `derivative v`
  [1]
  $ try 'f :: SF Velocity Distance\nf = proc v -> integral 2[m] v' 'f :: SF Velocity Distance\nf = proc v -> 2[m] + integral v'
  error[E0302]: `integral` takes 1 argument, but is given 2
    = hint: `integral` starts at 0: for another initial value, write `2[m] + integral v`; to restart it when an event occurs, write `resetOn integral (v, e)`
  [1]
  $ try 'f :: SF Velocity Distance\nf = proc v -> integral v 0.02[s]' 'f :: SF Velocity Distance\nf = proc v -> integral v'
  error[E0302]: `integral` takes 1 argument, but is given 2
    = hint: remove `0.02[s]`, because `integral` already multiplies by the time between two instants: write `integral v`
  [1]
  $ try 'f :: SF Velocity Bool\nf = proc v -> x > 1[m] where\n    x = delay 0 x + 0.02 * v' 'f :: SF Velocity Bool\nf = proc v -> x > 1[m] where\n    x = integral v'
  error[E0320]: the operands of `>` have different units: `m/s` and `m`
    = hint: for the sum over time, write `x = integral v`, which accounts for the time between two instants
  [1]
  $ try 'f :: SF Velocity Distance\nf = proc v -> x where\n    x = delay 0[m] x + v * 0.02' 'f :: SF Velocity Distance\nf = proc v -> x where\n    x = integral v'
  error[E0320]: the operands of `+` have different units: `m` and `m/s`
    = hint: for the sum over time, write `x = integral v`, which accounts for the time between two instants
  [1]
  $ try 'f :: SF Float Float\nf = proc v -> n where\n    n = delay n + 1' 'f :: SF Float Float\nf = proc v -> n where\n    n = delay 0 n + 1'
  error[E0303]: expected a value, found a signal function that is not applied to a signal
    = hint: `delay` takes an initial value before its signal: write `delay 0 n`
  [1]
  $ try 'f :: SF Bool Bool\nf = proc b -> if millis() < 5000 then b else False' 'f :: SF Bool Bool\nf = proc b -> if time () < 5000[ms] then b else False'
  error[E0205]: unknown name `millis`
    = hint: `time ()` is the time since the start: write `time () < 5000[ms]`
  [1]

Functions of two values with more of them:

  $ try 'f a b c = hold 0 (mergeE a b c)' 'f :: SF (Event Float, Event Float, Event Float) Float\nf = proc (a, b, c) -> hold 0 (mergeE a (mergeE b c))'
  error[E0302]: `mergeE` takes 2 arguments, but is given 3
    = hint: for three values, write `mergeE a (mergeE b c)`
  [1]
  $ try 'f x y z = 1 + min(x, y, z)' 'f x y z = 1 + min x (min y z)'
  error[E0301]: `min` takes two values, but is given 3
    = hint: write `min x (min y z)`
  [1]
  $ try 'f :: Event Float -> Event Float -> Event Float -> Event Float\nf a b c = mergeE [a, b, c]' 'f :: Event Float -> Event Float -> Event Float -> Event Float\nf a b c = mergeE a (mergeE b c)'
  error[E0301]: `mergeE` takes two values, but is given 3
    = hint: write `mergeE a (mergeE b c)`
  [1]
  $ try 'f :: AngularVelocity -> AngularVelocity\nf w = limit (-1[rad/s]) 1[rad/s] (0.25 * w + 0.5[1/s] * 2 + 0.125 * (w + w) / 2)' 'f :: AngularVelocity -> AngularVelocity\nf w = clamp (-1[rad/s]) 1[rad/s] (0.25 * w + 0.5[1/s] * 2 + 0.125 * (w + w) / 2)'
  error[E0302]: `limit` takes 2 arguments, but is given 3
    = hint: `limit` takes one limit for both directions; for two limits, write `clamp (-1[rad/s]) 1[rad/s] (0.25 * w + 0.5[1/s] * 2 + 0.125 * (w + w) / 2)`
  [1]

Events and conditions:

  $ try 'f :: Event () -> Event Float\nf e = mapE 3 e' 'f :: Event () -> Event Float\nf e = tag e 3'
  error[E0301]: expected `a -> b`, found a number
    = hint: `mapE` applies a function to the event's value: to replace the value, write `tag e 3`
  [1]
  $ try 'f :: Event () -> Event Float\nf e = mapE e 3' 'f :: Event () -> Event Float\nf e = tag e 3'
  error[E0301]: expected `a -> b`, found `Event ()`
    = hint: `mapE` applies a function to the event's value: to replace the value, write `tag e 3`
  [1]
  $ try 'f :: Bool -> Bool\nf b = isEvent b' 'f :: Bool -> Bool\nf b = b'
  error[E0301]: expected `Event a`, found `Bool`
    = hint: this is already a condition: write `b` in place of `isEvent b`; `edge b` is the event that occurs when it becomes True
  [1]
  $ try 'f :: SF Bool Float\nf = proc b -> toFloat n where\n    n = hold 0 b' 'f :: SF Bool Float\nf = proc b -> toFloat n where\n    n = hold 0 (count (edge b))'
  error[E0301]: expected `Event n[u]`, found `Bool`
    = hint: to count how often the condition becomes True, write `count (edge b)` here; to hold another value, write `tag (edge b) x` with that value in place of `x`
  [1]
  $ try 'low :: SF Float Bool\nlow = proc x -> x < 1\nf :: Task Float o c -> Task Float o (Either c ())\nf t = t `abortWhen` low' 'low :: SF Float Bool\nlow = proc x -> x < 1\nf :: Task Float o c -> Task Float o (Either c ())\nf t = t `abortWhen` (low >>> edge)'
  error[E0301]: expected `SF Float (Event a)`, found `SF Float Bool`
    = hint: its output is a condition: to get an event that occurs when the condition becomes True, write `(low >>> edge)`
  [1]
  $ try 'f :: SF Bool Time\nf = proc b -> resetOn time (edge b)' 'f :: SF Bool Time\nf = proc b -> resetOn time ((), edge b)'
  error[E0301]: expected `(a, Event ())`, found `Event ()`
    = hint: pass the input and the event as a pair: `resetOn time ((), edge b)`
  [1]

Tasks and signal functions:

  $ try 'main = reactimateTask (switch (forward 1[m]) (\\_ -> turnBy 90[deg]))' 'main = reactimateTask (do\n    forward 1[m]\n    turnBy 90[deg])'
  error[E0371]: expected a signal function, found a task
    = hint: `switch` changes between signal functions: to run one task after the other, write `forward 1[m]` and `turnBy 90[deg]` on separate lines below a `do`
  [1]
  $ try 'main = reactimateRobot (switch (proc i -> (roMake (setVelTR 0.2[m/s] 0), edge (bumped i))) (\\_ -> turnBy 90[deg]))' 'main = reactimateTask (do\n    mkTask (proc i -> (roMake (setVelTR 0.2[m/s] 0), edge (bumped i)))\n    turnBy 90[deg])'
  error[E0371]: expected a signal function, found a task
    = hint: `switch` continues with a signal function: to continue with a task, use a `do` instead, with `mkTask (…)` around the first argument of `switch` on its first line and `turnBy 90[deg]` on its second; `reactimateTask` turns the `do` into a program
  [1]
  $ try 'main = reactimateTask (do\n    while True: forward 1[m])' 'main = reactimateTask (do\n    forever (forward 1[m]))'
  error[E0103]: unexpected character `:`
    = hint: to repeat a task, write `forever (forward 1[m])`
  [1]

Other values:

  $ try 'main = reactimateRobot (proc _ -> roMake (setVelTR 0 0))\ntrial "t" = Trial { world = "room.toml", lasts = 5[s], seeds = [1, 2, 3], judge = neverTouches }' 'main = reactimateRobot (proc _ -> roMake (setVelTR 0 0))\ntrial "t" = Trial { world = "room.toml", lasts = 5[s], seeds = 1 `to` 3, judge = neverTouches }'
  error[E0301]: expected `Seeds`, found `Array 3 n[1]`
    = hint: write the first and the last seed: ``1 `to` 3``
  [1]
  $ try 'data Battery = Battery { volts :: Float[V], amps :: Float[A] }\nf b = (b :: Battery).voltage' 'data Battery = Battery { volts :: Float[V], amps :: Float[A] }\nf b = (b :: Battery).volts'
  error[E0310]: `Battery` has no field `voltage`
    = hint: did you mean `volts`?
  [1]
  $ try 'f :: SF Distance AngularVelocity\nf = proc d -> limit 1[rad/s] (4 * d + 3[1/m] * derivative d)' 'f :: SF Distance AngularVelocity\nf = proc d -> limit 1[rad/s] (4[1/m/s] * d + 3[1/m] * derivative d)'
  error[E0320]: the operands of `+` have different units: `m` and `1/s`
    = hint: if the gain `4` should have a unit, like the gain in the other operand, write `4[1/m/s]`
  [1]
  $ try 'f :: Distance -> Point2\nf d = toFrame (Pose { position = p, heading = 0 }) p where\n    p = Vec2 { x = d ^ 2 * 2, y = d }' 'f :: Distance -> Point2\nf d = toFrame (Pose { position = p, heading = 0 }) p where\n    p = Vec2 { x = d * 2, y = d }'
  error[E0320]: expected the unit `m`, found `m^2`
    = hint: for a field in `m`, write `d * 2`
  error[E0320]: expected the unit `m^2`, found `m`
    = hint: the two fields must have the same unit: if `d` is right, write `x = d * 2`
  [1]
