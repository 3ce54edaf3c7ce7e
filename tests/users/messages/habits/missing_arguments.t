Arguments that are missing, or that lack their parentheses.

A function that returns a signal function, without its argument:

  $ cat > follow.frob <<'FROB'
  > import Robot
  > param gap :: Distance = 0.4[m]
  > 
  > follow :: Distance -> SF RobotInput RobotOutput
  > follow d = proc i -> roMake (setVelTR v 0) where
  >     v = min 0.3[m/s] (0.5[1/s] * (frontSonar i - d))
  > 
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot follow
  > FROB
  $ frobc check follow.frob
  error[E0304]: expected a signal function, found a function: `Distance -> SF RobotInput RobotOutput`
   --> follow.frob:9:24
    |
  9 | main = reactimateRobot follow
    |        --------------- ^^^^^^
    |        |
    |        argument 1 of `reactimateRobot` is `SF a b`
    |
    = hint: `follow` lacks its argument, `Distance` (m): write `follow gap`
  
  1 error
  [1]
  $ sed 's/reactimateRobot follow/reactimateRobot (follow gap)/' follow.frob > pasted.frob && frobc check pasted.frob

If no definition of the program has the type, the hint shows an example:

  $ cat > back.frob <<'FROB'
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot ahead
  > 
  > ahead :: SF RobotInput RobotOutput
  > ahead = switch
  >     (proc i -> (roMake (setVelTR 0.3[m/s] 0), edge (bumped i)))
  >     (\_ -> back)
  > 
  > back :: AngularVelocity -> SF RobotInput RobotOutput
  > back w = proc _ -> roMake (setVelTR (-0.2[m/s]) w)
  > FROB
  $ frobc check back.frob
  error[E0304]: expected a signal function, found a function: `AngularVelocity -> SF RobotInput RobotOutput`
   --> back.frob:8:12
    |
  6 | ahead = switch
    |         ------ the result of argument 2 of `switch` is `SF a b`
  7 |     (proc i -> (roMake (setVelTR 0.3[m/s] 0), edge (bumped i)))
  8 |     (\_ -> back)
    |            ^^^^
    |
    = hint: `back` lacks its argument, `AngularVelocity` (1/s): write `back 1[rad/s]`
  
  1 error
  [1]
  $ sed 's/-> back)/-> back 1[rad\/s])/' back.frob > pasted.frob && frobc check pasted.frob

The value that a task returns, without parentheses. Only in front of a task is `return` superfluous:

  $ cat > returned.frob <<'FROB'
  > import Geometry
  > import Robot
  > 
  > go :: (HasSonar i, DiffDrive o) => Task i o Distance
  > go = do
  >     start <- robotPlace
  >     forward 1[m]
  >     end <- robotPlace
  >     return distance start end
  > 
  > main :: Program RobotInput RobotOutput
  > main = reactimateTask (watching go)
  > FROB
  $ frobc check returned.frob
  error[E0302]: `return` takes 1 argument, but is given 3
   --> returned.frob:9:21
    |
  9 |     return distance start end
    |     ------          ^^^^^ too many from here on
    |     |
    |     with one argument, its result is `Task a b (Vec2[u] -> Vec2[u] -> Float[u])`
    |
    = hint: put parentheses around the argument: `return (distance start end)`
  
  1 error
  [1]
  $ sed 's/return distance start end/return (distance start end)/' returned.frob > pasted.frob && frobc check pasted.frob

  $ cat > returned_task.frob <<'FROB'
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateTask (return forward 1[m])
  > FROB
  $ frobc check returned_task.frob
  error[E0302]: `return` takes 1 argument, but is given 2
   --> returned_task.frob:3:39
    |
  3 | main = reactimateTask (return forward 1[m])
    |                        ------         ^^^^ one too many
    |                        |
    |                        with one argument, its result is `Task a b (Distance -> Task c d Bool)`
    |
    = hint: to run a task, remove `return`: `forward 1[m]`
  
  1 error
  [1]
  $ sed 's/return forward/forward/' returned_task.frob > pasted.frob && frobc check pasted.frob

A decimal literal in place of an integer does not suggest that the types of the signature are in the
wrong order:

  $ cat > sign.frob <<'FROB'
  > sign :: Float -> Int
  > sign x
  >     | x > 0     = 1
  >     | otherwise = 0.5
  > 
  > main :: SF Float Int
  > main = proc x -> sign x
  > FROB
  $ frobc check sign.frob
  error[E0312]: expected `Int`, found `Float`
   --> sign.frob:4:19
    |
  1 | sign :: Float -> Int
    |         ------------ the signature of `sign` requires `Int`
  ...
  4 |     | otherwise = 0.5
    |                   ^^^
    |
    = hint: write `round 0.5`, or use `floor`, `ceiling` or `truncate` instead of `round`
  
  1 error
  [1]

A function of two numbers with only one of them, an input:

  $ cat > smaller.frob <<'FROB'
  > smaller :: Float -> Float -> Float
  > smaller a b = if a < b then a else b
  > 
  > main :: SF (Float, Float) (Float, Bool)
  > main = proc (a, b) -> (smaller a, a > b)
  > FROB
  $ frobc check smaller.frob
  error[E0301]: expected `Float`, found the function `Float -> Float`
   --> smaller.frob:5:24
    |
  4 | main :: SF (Float, Float) (Float, Bool)
    |         ------------------------------- by the signature of `main`, the first component of the output is `Float`
  5 | main = proc (a, b) -> (smaller a, a > b)
    |                        ^^^^^^^^^
    |
    = hint: `smaller` takes two arguments, `smaller a b`, but `b` is missing here: write, for example, `smaller a b`
  
  1 error
  [1]
  $ sed 's/(smaller a,/(smaller a b,/' smaller.frob > pasted.frob && frobc check pasted.frob

A sum or an extreme without the value that it begins with:

  $ cat > longest.frob <<'FROB'
  > main :: SF (Array 5 Distance) (Distance, Distance)
  > main = proc row -> (total, longest) where
  >     total   = sum row
  >     longest = foldl max row
  > FROB
  $ frobc check longest.frob
  error[E0301]: expected `Distance` (m), found the function `Array m (Array 5 Distance) -> Array 5 Distance`
   --> longest.frob:2:28
    |
  1 | main :: SF (Array 5 Distance) (Distance, Distance)
    |         ------------------------------------------ by the signature of `main`, the second component of the output is `Distance` (m)
  2 | main = proc row -> (total, longest) where
    |                            ^^^^^^^
  3 |     total   = sum row
  4 |     longest = foldl max row
    |               ------------- this is `longest`; it lacks its second argument
    |
    = hint: `foldl` needs an initial value: write `foldl max 0 row`
  
  1 error
  [1]
  $ sed 's/foldl max row/foldl max 0 row/' longest.frob > pasted.frob && frobc check pasted.frob

An argument is missing before another one:

  $ try () { # DEFINITIONS CORRECTED-DEFINITIONS
  >   printf 'import Control\nimport Robot\n%s\n' "$1" > program.frob
  >   frobc check program.frob 2>&1 | grep '^error\|hint'
  >   printf 'import Control\nimport Robot\n%s\n' "$2" > corrected.frob
  >   frobc check corrected.frob 2>&1 | grep '^error'
  > }
  $ speed='f :: SF RobotInput Velocity
  > f = proc i -> '
  $ generic='f :: (HasConsole i, HasSonar i) => SF i Velocity
  > f = proc i -> '

  $ try "$speed"'knob "speed" 0 0.4[m/s] i' "$speed"'knob "speed" 0 0.4[m/s] 0 i'
  error[E0301]: `knob` lacks an argument before `i`
    = hint: write `knob "speed" 0 0.4[m/s] 0 i`, with the value that you want in place of `0`
  [1]

  $ try "$generic"'knob "speed" 0 0.4[m/s] i' "$generic"'knob "speed" 0 0.4[m/s] 0 i'
  error[E0301]: `knob` lacks an argument before `i`
    = hint: write `knob "speed" 0 0.4[m/s] 0 i`, with the value that you want in place of `0`
  [1]

  $ try "$generic"'if buttonHeld i then 1[m/s] else 0' "$generic"'if buttonHeld "name" i then 1[m/s] else 0'
  error[E0301]: `buttonHeld` lacks an argument before `i`
    = hint: write `buttonHeld "name" i`, with the value that you want in place of `"name"`
  [1]

  $ try "$speed"'lowPass (derivative (frontSonar i))' "$speed"'lowPass 1[s] (derivative (frontSonar i))'
  error[E0301]: `lowPass` lacks an argument before `(derivative (frontSonar i))`
    = hint: write `lowPass 1[s] (derivative (frontSonar i))`, with the value that you want in place of `1[s]`
  [1]

  $ try 'f :: SF Distance Distance
  > f = proc x -> delayBy x' 'f :: SF Distance Distance
  > f = proc x -> delayBy 1[s] x'
  error[E0301]: `delayBy` lacks an argument before `x`
    = hint: write `delayBy 1[s] x`, with the value that you want in place of `1[s]`
  [1]

But a constant is more likely to have the wrong unit, and a signal function belongs to its place:

  $ try 'f :: SF Distance Distance
  > f = lowPass 0.5' 'f :: SF Distance Distance
  > f = lowPass 0.5[s]'
  error[E0320]: expected the unit `s`, found none
    = hint: write `0.5[s]` if that is the right unit
  [1]

A context can only constrain a variable, so no hint replaces a variable in it. The signature in a
hint is complete:

  $ try 'f :: (HasSonar i, DiffDrive o) => a -> SF i o
  > f x = proc i -> roMake (setVelTR (if frontSonar i < 1[m] then x else 0) 0)' 'f :: (HasSonar i, DiffDrive o) => Float[m/s] -> SF i o
  > f x = proc i -> roMake (setVelTR (if frontSonar i < 1[m] then x else 0) 0)'
  error[E0306]: the signature allows any type `a`, but the definition needs it to be `Float[m/s]`
    = hint: if the definition is right, write the signature as `(HasSonar i, DiffDrive o) => Float[m/s] -> SF i o`
  [1]
