More of Python, Haskell and C: objects, comments, lists, named arguments.

  $ cat > named.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR (v=0.2, omega=0)))
  > FROB
  $ frobc check named.frob
  error[E0110]: expected an operator, `,` or `)`, found `=`
   --> named.frob:2:54
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR (v=0.2, omega=0)))
    |                                                      ^
    |
    = hint: arguments are passed by position, not by name: write `f 1 2`
  
  1 error
  [1]

A class with a method: reported once.

  $ cat > objects.frob <<'FROB'
  > class Wall:
  >     def __init__(self):
  >         self.d = 0.5
  > main :: SF Float Float
  > main = proc x -> x
  > FROB
  $ frobc check objects.frob
  error[E0103]: unexpected character `:`
   --> objects.frob:1:11
    |
  1 | class Wall:
    |           ^
    |
    = hint: Frob has no objects: declare a record with `data`, and define its functions at the top level
  
  1 error
  [1]

  $ cat > docstring.frob <<'FROB'
  > """Wall follower."""
  > import Robot
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0 0))
  > FROB
  $ frobc check docstring.frob
  error[E0110]: expected `=` after the left-hand side of a definition, found the end of the definition
   --> docstring.frob:1:21
    |
  1 | """Wall follower."""
    |                     ^
    |
    = hint: write a comment as `-- …`, or as `-- | …` to document the definition below
  
  1 error
  [1]

  $ cat > macro.frob <<'FROB'
  > #define SPEED 0.3
  > import Robot
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0 0))
  > FROB
  $ frobc check macro.frob
  error[E0103]: unexpected character `#`
   --> macro.frob:1:1
    |
  1 | #define SPEED 0.3
    | ^
    |
    = hint: define a constant by an equation: `speed = 0.3`
  
  1 error
  [1]

  $ cat > arrow.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = if i->frontSonar < 0.5[m] then 0 else 0.2[m/s])
  > FROB
  $ frobc check arrow.frob
  error[E0110]: expected `then` after the condition, found `->`
   --> arrow.frob:3:13
    |
  3 |     v = if i->frontSonar < 0.5[m] then 0 else 0.2[m/s])
    |             ^^
    |
    = hint: to read a sensor, write `frontSonar i`; for a field, `i.frontSonar`
  
  1 error
  [1]

  $ cat > cons.frob <<'FROB'
  > main :: SF Float (Array 3 Float)
  > main = proc x -> x : [0, 0]
  > FROB
  $ frobc check cons.frob
  error[E0103]: unexpected character `:`
   --> cons.frob:2:20
    |
  2 | main = proc x -> x : [0, 0]
    |                    ^
    |
    = hint: an array has a fixed size: write all its elements, as in `[x, 0, 0]`
  
  1 error
  [1]

  $ cat > io.frob <<'FROB'
  > import Robot
  > main :: IO ()
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0 0))
  > FROB
  $ frobc check io.frob
  error[E0207]: unknown type `IO`
   --> io.frob:2:9
    |
  2 | main :: IO ()
    |         ^^
    |
    = hint: give `main` the type `Program RobotInput RobotOutput`, or make it a signal function
  
  1 error
  [1]

  $ cat > strict.frob <<'FROB'
  > data P = P !Float !Float
  > main :: SF Float Float
  > main = proc x -> x
  > FROB
  $ frobc check strict.frob
  error[E0110]: Frob has no prefix `!`
   --> strict.frob:1:12
    |
  1 | data P = P !Float !Float
    |            ^
    |
    = hint: remove the `!`: fields are always evaluated
  
  1 error
  [1]

  $ cat > condition.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> case x of
  >     x > 0 -> 1
  >     _ -> 0
  > FROB
  $ frobc check condition.frob
  error[E0114]: the operator `>` cannot be part of a pattern
   --> condition.frob:3:7
    |
  3 |     x > 0 -> 1
    |       ^
    |
    = hint: write the condition as a guard after the pattern: `x | x > 0 -> 1`
  
  1 error
  [1]

  $ cat > parentheses.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0.3(m/s) 0))
  > FROB
  $ frobc check parentheses.frob
  error[E0205]: there is a space between this unit and its number
   --> parentheses.frob:2:55
    |
  2 | main = reactimateRobot (proc _ -> roMake (setVelTR 0.3(m/s) 0))
    |                                                       ^^^^^
    |
    = hint: write the unit in square brackets directly after the number: `0.3[m/s]`
  
  1 error
  [1]
