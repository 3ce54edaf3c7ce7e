Signal functions used as functions: not run, composed with `.`, given a function's type.

  $ cat > unrun.frob <<'FROB'
  > import Control
  > main :: SF Float Float
  > main = proc x -> lowPass 0.5[s] + x
  > FROB
  $ frobc check unrun.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> unrun.frob:3:18
    |
  3 | main = proc x -> lowPass 0.5[s] + x
    |                  ^^^^^^^^^^^^^^ - argument 1 of `+` is a number
    |                  |
    |                  this is `SF Float[u] Float[u]`
    |
    = note: expected a number
    = hint: add a signal as the last argument: `lowPass 0.5[s] x`
  
  1 error
  [1]

  $ cat > composed.frob <<'FROB'
  > main :: SF Float Float
  > main = integral . derivative
  > FROB
  $ frobc check composed.frob
  error[E0304]: expected a function, found a signal function: `SF Float[u] Float[u s]`
   --> composed.frob:2:8
    |
  2 | main = integral . derivative
    |        ^^^^^^^^ - argument 1 of `.` is `b -> c`
    |
    = hint: compose signal functions from left to right with `>>>`: `derivative >>> integral`
  
  1 error
  [1]

  $ cat > type.frob <<'FROB'
  > main :: Float -> Float
  > main = proc x -> x + 1
  > FROB
  $ frobc check type.frob
  error[E0304]: expected a function, found a signal function: `SF a b`
   --> type.frob:2:8
    |
  1 | main :: Float -> Float
    |         -------------- the signature of `main` requires `Float -> Float`
  2 | main = proc x -> x + 1
    |        ^^^^^^^^^^^^^^^
    |
    = hint: if you want a signal function, change the type to `SF Float Float`
  
  1 error
  [1]

A value of another type is reported once, not once per branch.

  $ cat > event.frob <<'FROB'
  > main :: SF (Event Float) Float
  > main = proc e -> case e of
  >     Just x -> x
  >     Nothing -> 0
  > FROB
  $ frobc check event.frob
  error[E0301]: this pattern matches `Maybe a`, but the value is `Event Float`
   --> event.frob:3:5
    |
  2 | main = proc e -> case e of
    |                       - the value is `Event Float`
  3 |     Just x -> x
    |     ^^^^^^
    |
    = hint: match an event with the patterns `Event x` and `NoEvent`
  
  1 error
  [1]

A parameter that a definition runs is a function unless its signature says `SF`.

  $ cat > twice.frob <<'FROB'
  > twice h = proc x -> h (h x)
  > main :: SF Float Float
  > main = twice (delay 0)
  > FROB
  $ frobc check twice.frob
  error[E0304]: expected a function, found a signal function: `SF n[u] n[u]`
   --> twice.frob:3:15
    |
  3 | main = twice (delay 0)
    |        -----  ^^^^^^^
    |        |
    |        argument 1 of `twice` is `a -> a`
    |
    = hint: if `twice` should run the signal function, give the parameter an `SF` type in the signature of `twice`
  
  1 error
  [1]

A missing initial value.

  $ cat > initial.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> y where
  >     y = delay (y + x)
  > FROB
  $ frobc check initial.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> initial.frob:3:9
    |
  3 |     y = delay (y + x)
    |     -   ^^^^^^^^^^^^^ this is `SF Float Float`
    |     |
    |     elsewhere `y` is used as `Float`
    |
    = note: expected `Float`
    = hint: `delay` takes an initial value before its signal: write `delay 0 (y + x)`
  
  1 error
  [1]

A Bool where an event is expected.

  $ cat > truth.frob <<'FROB'
  > main :: SF Bool Float
  > main = proc b -> hold 0.0 b
  > FROB
  $ frobc check truth.frob
  error[E0301]: expected `Event Float[u]`, found `Bool`
   --> truth.frob:2:27
    |
  2 | main = proc b -> hold 0.0 b
    |                  ---- --- ^
    |                  |    |
    |                  |    because this is `Float[u]`
    |                  argument 2 of `hold` is `Event Float[u]`
    |
    = hint: use `tag (edge b) x`, which occurs with the value of `x` when the condition becomes True
  
  1 error
  [1]

Operators on Bools do not accept events.

  $ cat > operators.frob <<'FROB'
  > either, both :: Event Int -> Event Int -> Event Int
  > either a b = a || b
  > both a b = a && b
  > 
  > quiet :: SF Bool Bool
  > quiet = proc b -> not (edge b)
  > FROB
  $ frobc check operators.frob
  error[E0301]: expected `Bool`, found `Event Int`
   --> operators.frob:2:14
    |
  2 | either a b = a || b
    |              ^ -- argument 1 of `||` is `Bool`
    |
    = hint: use `mergeE a b`, which occurs when either event does
  
  error[E0301]: expected `Bool`, found `Event Int`
   --> operators.frob:3:12
    |
  3 | both a b = a && b
    |            ^ -- argument 1 of `&&` is `Bool`
    |
    = hint: use `pairEvents a b`, which occurs when both events do, or `gate e b`, which occurs only while `b` is True
  
  error[E0301]: expected `Bool`, found `Event ()`
   --> operators.frob:6:24
    |
  6 | quiet = proc b -> not (edge b)
    |                   ---  ^^^^^^
    |                   |
    |                   argument 1 of `not` is `Bool`
    |
    = hint: to test whether the condition is True, write `b`; to test whether it becomes True in this instant, write `isEvent (edge b)`
  
  3 errors
  [1]

The event that ends a mode was not run; a function determines when a task is aborted.

  $ cat > unrun.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (switch slow (\_ -> fast)) where
  >     slow = proc i -> (roMake (setVelTR 0.1[m/s] 0), after 5[s])
  >     fast = proc i -> roMake (setVelTR 0.4[m/s] 0)
  > FROB
  $ frobc check unrun.frob
  error[E0301]: expected `SF a (b, Event c)`, found `SF a (b, SF d (Event ()))`
   --> unrun.frob:2:32
    |
  2 | main = reactimateRobot (switch slow (\_ -> fast)) where
    |                         ------ ^^^^
    |                         |
    |                         argument 1 of `switch` is `SF a (b, Event c)`
    |
    = hint: run the event's signal function on a signal, as in `after 5[s] ()`
  
  1 error
  [1]

  $ cat > given_up.frob <<'FROB'
  > import Robot
  > main = reactimateTask (sleepT 5[s] (roMake (setVelTR 0.1[m/s] 0)) `abortWhen` bumped)
  > FROB
  $ frobc check given_up.frob
  error[E0304]: expected a signal function, found a function: `c -> Bool`
   --> given_up.frob:2:79
    |
  2 | main = reactimateTask (sleepT 5[s] (roMake (setVelTR 0.1[m/s] 0)) `abortWhen` bumped)
    |                                                                   ----------- ^^^^^^
    |                                                                   |
    |                                                                   argument 2 of `abortWhen` is `SF a (Event b)`
    |
    = hint: use `proc x -> edge (bumped x)`: its event occurs when the condition becomes True
  
  1 error
  [1]
