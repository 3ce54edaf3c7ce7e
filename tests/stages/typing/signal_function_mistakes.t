A signal function is not a signal: it must be run.

  $ cat > unrun.frob <<FROB
  > clock :: SF () Time
  > clock = proc () -> time
  > 
  > late :: SF () Bool
  > late = proc () -> time > 10[s]
  > 
  > speed :: SF Distance Velocity
  > speed = proc d -> derivative + 1[m/s]
  > FROB
  $ frobc check unrun.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> unrun.frob:2:20
    |
  1 | clock :: SF () Time
    |          ---------- the signature of `clock` requires the output `Time` (s)
  2 | clock = proc () -> time
    |                    ^^^^ this is `SF a Time`
    |
    = note: expected `Time` (s)
    = hint: run the signal function on `()`: `time ()`
  
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> unrun.frob:5:19
    |
  5 | late = proc () -> time > 10[s]
    |                   ^^^^   ----- this is a number in `s`
    |                   |
    |                   this is `SF a Time`
    |
    = hint: run the signal function on `()`: `time ()`
  
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> unrun.frob:8:19
    |
  8 | speed = proc d -> derivative + 1[m/s]
    |                   ^^^^^^^^^^ - argument 1 of `+` is a number
    |                   |
    |                   this is `SF Float[u] Float[u/s]`
    |
    = note: expected a number
    = hint: run the signal function on `d`: `derivative d`
  
  3 errors
  [1]

A function is not a signal function.

  $ cat > functions.frob <<FROB
  > wave :: SF Float Float
  > wave = sin
  > 
  > waves = identity >>> cos
  > 
  > run = proc x -> do
  >   y <- sin -< x
  >   returnA -< y
  > 
  > slope = arr derivative
  > FROB
  $ frobc check functions.frob
  error[E0304]: expected a signal function, found a function: `Angle -> Float`
   --> functions.frob:2:8
    |
  1 | wave :: SF Float Float
    |         -------------- the signature of `wave` requires `SF Float Float`
  2 | wave = sin
    |        ^^^
    |
    = hint: use `arr` to turn a function into a signal function: `arr sin`
  
  error[E0304]: expected a signal function, found a function: `Angle -> Float`
   --> functions.frob:4:22
    |
  4 | waves = identity >>> cos
    |         --------     ^^^
    |         |
    |         this is `SF a a`
    |
    = hint: use `arr` to turn a function into a signal function: `arr cos`
  
  error[E0304]: `-<` needs a signal function, but this is `Angle -> Float`
   --> functions.frob:7:8
    |
  7 |   y <- sin -< x
    |        ^^^
    |
    = hint: use `arr` to turn a function into a signal function
  
  error[E0304]: expected a function, found a signal function: `SF Float[u] Float[u/s]`
    --> functions.frob:10:13
     |
  10 | slope = arr derivative
     |         --- ^^^^^^^^^^
     |         |
     |         argument 1 of `arr` is `a -> b`
     |
     = hint: remove `arr`
  
  4 errors
  [1]

Too many and too few arguments.

  $ cat > arguments.frob <<FROB
  > total = proc v -> integral v 2
  > 
  > largest = max 1.0 2.0 3.0
  > 
  > root x = 1.0 + hypot x
  > 
  > two :: Float -> Float
  > two x y = x
  > FROB
  $ frobc check arguments.frob
  error[E0302]: `integral` takes 1 argument, but is given 2
   --> arguments.frob:1:30
    |
  1 | total = proc v -> integral v 2
    |                   --------   ^ one too many
    |                   |
    |                   with one argument, its result is `Float[u s]`
    |
    = hint: `integral` starts at 0: for another initial value, write `x0 + integral v`; to restart it when an event occurs, write `resetOn integral (v, e)`
  
  error[E0302]: `max` takes 2 arguments, but is given 3
   --> arguments.frob:3:23
    |
  3 | largest = max 1.0 2.0 3.0
    |           ---         ^^^ one too many
    |           |
    |           with 2 arguments, its result is `Float`
    |
    = hint: for three values, write `max 1.0 (max 2.0 3.0)`
  
  error[E0301]: expected `Float`, found the function `Float[u] -> Float[u]`
   --> arguments.frob:5:16
    |
  5 | root x = 1.0 + hypot x
    |          ---   ^^^^^^^
    |          |
    |          this is `Float`
    |
    = hint: the second argument of `hypot` is missing: `hypot :: Float[u] -> Float[u] -> Float[u]`
  
  error[E0302]: `two` has more than one parameter, but its type allows only one
   --> arguments.frob:8:7
    |
  7 | two :: Float -> Float
    |        -------------- the signature of `two` requires `Float -> Float`
  8 | two x y = x
    |       ^
    |
    = hint: the signature needs a type for each parameter (`x`, `y`) and one for the result: `two :: … -> … -> …`
  
  4 errors
  [1]
