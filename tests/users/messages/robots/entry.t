For a definition that cannot be the entry, the message says why, and what could
be.

  $ cat > entries.frob <<'FROB'
  > main = 3
  > 
  > f :: Float -> Float
  > f x = x
  > 
  > open :: SF a a
  > open = proc x -> x
  > 
  > scaled :: Float -> SF Float Float
  > scaled k = proc x -> k * x
  > FROB
  $ frobc compile entries.frob
  error[E0411]: `main` cannot run: it is a value, not a signal function
   --> entries.frob:1:1
    |
  1 | main = 3
    | ^^^^^^^^
    |
    = hint: use `constant e` for a signal function that always outputs the value `e`, or `main = reactimateRobot (constant e)` for a robot program
  
  1 error
  [1]
  $ frobc compile entries.frob --entry f
  error[E0411]: `f` cannot run: it is a function, `Float -> Float`, not a signal function
   --> entries.frob:4:1
    |
  4 | f x = x
    | ^^^^^^^
    |
    = hint: use `arr f` to apply it at every instant
  
  1 error
  [1]
  $ frobc compile entries.frob --entry open
  error[E0411]: `open` cannot run: its type `SF a a` has variables, so the input or the output is not determined
   --> entries.frob:7:1
    |
  7 | open = proc x -> x
    | ^^^^^^^^^^^^^^^^^^
    |
    = hint: give it a signature without variables, such as `open :: SF Float Float`
  
  1 error
  [1]
  $ frobc compile entries.frob --entry scaled
  error[E0411]: `scaled` cannot run: it still needs an argument, as its type `Float -> SF Float Float` shows
    --> entries.frob:10:1
     |
  10 | scaled k = proc x -> k * x
     | ^^^^^^^^^^^^^^^^^^^^^^^^^^
     |
     = hint: define a signal function that supplies the argument, as in `main = scaled …`
  
  1 error
  [1]

The types in the message are those that a signature would have, including units and classes.

  $ cat > typed.frob <<'FROB'
  > -- areas and speeds
  > area :: Float[m] -> Float[m] -> Float[m^2]
  > area a b = a * b
  > 
  > least :: (Ord a, Eq b) => a -> b -> Maybe b -> a -> a
  > least x y z w = if x < w && z == Just y then x else w
  > 
  > main :: Velocity -> Float
  > main v = v / 1[m/s]
  > FROB
  $ frobc check typed.frob
  error[E0411]: `main` cannot run: it is a function, `Float[m/s] -> Float`, not a signal function
   --> typed.frob:9:1
    |
  9 | main v = v / 1[m/s]
    | ^^^^^^^^^^^^^^^^^^^
    |
    = hint: write `main :: SF (Float[m/s]) Float` and `main = proc x -> …`
  
  1 error
  [1]
  $ sed -e 's/main :: .*/main :: SF Float[m\/s] Float/' -e 's/main v =/main = proc v ->/' typed.frob > pasted.frob && frobc check pasted.frob
  $ frobc compile typed.frob --entry area
  error[E0411]: `area` cannot run: it is a function, `Float[m] -> Float[m] -> Float[m^2]`, not a signal function
   --> typed.frob:3:1
    |
  3 | area a b = a * b
    | ^^^^^^^^^^^^^^^^
    |
    = hint: use `proc (a, b) -> area a b` to apply it at every instant
  
  1 error
  [1]
  $ frobc compile typed.frob --entry least
  error[E0411]: `least` cannot run: it is a function, `(Ord a, Eq b) => a -> b -> Maybe b -> a -> a`, not a signal function
   --> typed.frob:6:1
    |
  6 | least x y z w = if x < w && z == Just y then x else w
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: use `proc (a, b, c, d) -> least a b c d` to apply it at every instant
  
  1 error
  [1]

A program that leaves its robot open cannot be run without an option.

  $ cat > robot.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc _ -> 0.3[m/s])
  > FROB
  $ frobc check robot.frob
  error[E0411]: `main` cannot run: its type is `Program a Float[m/s]`, so its output is not a robot's output
   --> robot.frob:2:35
    |
  2 | main = reactimateRobot (proc _ -> 0.3[m/s])
    |                                   ^^^^^^^^
    |
    = hint: use `roMake` to create a robot's output, as in `roMake (setVelTR v omega)`
  
  1 error
  [1]
