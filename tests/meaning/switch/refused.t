A signal function that restarts itself as a part of an expression would run inside itself; the
message names the enclosing expression.

  $ cat > inside.frob <<'EOF'
  > main :: SF Float Float
  > main = switch (proc x -> (x, edge (x > 1))) (\_ -> arr (\x -> (x, x)) >>> first main >>> arr fst)
  > EOF
  $ frobc check inside.frob
  error[E0415]: `main` restarts itself inside itself
   --> inside.frob:2:52
    |
  2 | main = switch (proc x -> (x, edge (x > 1))) (\_ -> arr (\x -> (x, x)) >>> first main >>> arr fst)
    |                                                    ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ here, inside `>>>`, inside `first`
    |
    = note: a signal function may only restart itself as the whole result of a continuation; otherwise each restart would need more memory
    = hint: apply `>>>`, `first` once, where the first mode starts, not in each mode
  
  1 error
  [1]

A signal function that grows at each restart would need a mode for each size.

  $ cat > grows.frob <<'EOF'
  > go :: SF Float Float -> SF Float Float
  > go sf = switch (proc x -> (sf x, edge (x > 1))) (\_ -> go (sf >>> delay 0))
  > 
  > main = go identity
  > EOF
  $ frobc check grows.frob
  error[E0416]: `go` grows each time it restarts itself
   --> grows.frob:2:56
    |
  2 | go sf = switch (proc x -> (sf x, edge (x > 1))) (\_ -> go (sf >>> delay 0))
    |                                                        ^^^^^^^^^^^^^^^^^^^ it restarts here, with one more `>>>`
    |
    = note: frobc must know all signal functions that can run, so their number must be finite
    = hint: restart it with the same signal functions each time; only numbers may change
  
  1 error
  [1]

The same for one that restarts itself at larger types.

  $ cat > types.frob <<'EOF'
  > go :: Eq a => a -> SF Float Float
  > go v = switch (proc x -> (x, edge (x > 1 && v == v))) (\_ -> go (v, v))
  > 
  > main = go 1
  > EOF
  $ frobc check types.frob
  error[E0417]: `go` restarts itself at a larger type
   --> types.frob:2:62
    |
  2 | go v = switch (proc x -> (x, edge (x > 1 && v == v))) (\_ -> go (v, v))
    | -------------------------------------------------------------^^--------
    | |                                                            |
    | |                                                            here its type variable becomes `(a, a)`
    | `go` is defined here
    |
    = hint: restart it with the same types
  
  1 error
  [1]

A signal function that calls itself outside a continuation.

  $ cat > calls.frob <<'EOF'
  > main :: SF Float Float
  > main = switch (main &&& (arr (\x -> x > 1) >>> edge)) (\_ -> constant 0)
  > EOF
  $ frobc check calls.frob
  error[E0410]: `main` calls itself
   --> calls.frob:2:1
    |
  2 | main = switch (main &&& (arr (\x -> x > 1) >>> edge)) (\_ -> constant 0)
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |                |
    |                `main` uses `main` here
    |
    = note: functions cannot be recursive: use `foldl` or `scanl` to process an array; a signal function may only restart itself in the continuation of a switch
    = hint: for a value that depends on its own past, write an equation with `delay` in a `proc`, as in `n = delay 0 n + 1`
  
  1 error
  [1]

A continuation must be static.

  $ cat > signal.frob <<'EOF'
  > main :: SF Float Float
  > main = proc x -> switch (proc y -> (y, edge (y > 1))) (\_ -> constant x) x
  > EOF
  $ frobc check signal.frob
  error[E0340]: the arguments of `switch` before its signal must be static, but `x` is a signal
   --> signal.frob:2:71
    |
  2 | main = proc x -> switch (proc y -> (y, edge (y > 1))) (\_ -> constant x) x
    |             -                                                         ^
    |             |
    |             `x` is a signal: it comes from the `proc`'s input here
    |
    = hint: pass the value in the event of the `switch`, or use `initially`
  
  1 error
  [1]

A signal function in an event cannot be stored.

  $ cat > stored.frob <<'EOF'
  > main :: SF Float Float
  > main = proc x -> rSwitch identity (x, delay NoEvent (tag (edge (x > 2)) (constant x)))
  > EOF
  $ frobc check stored.frob
  error[E0412]: a value of type `Event (SF Float Float)` cannot be stored in a `delay`
   --> stored.frob:2:39
    |
  2 | main = proc x -> rSwitch identity (x, delay NoEvent (tag (edge (x > 2)) (constant x)))
    |                                       ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: functions, signal functions and labels only exist at compile time
  
  1 error
  [1]

Growth and larger types through several definitions: the message shows the
cycle.

  $ cat > round.frob <<'FROB'
  > go, back :: SF Float Float -> SF Float Float
  > go sf = switch (proc x -> (sf x, edge (x > 1))) (\_ -> back (sf >>> arr (+ 1)))
  > back sf = switch (proc x -> (sf x, edge (x < 1))) (\_ -> turn (sf &&& sf))
  > 
  > turn :: SF Float (Float, Float) -> SF Float Float
  > turn sf = go (sf >>> arr fst)
  > 
  > main = go identity
  > FROB
  $ frobc check round.frob
  error[E0416]: `go` grows each time it restarts itself
   --> round.frob:3:58
    |
  2 | go sf = switch (proc x -> (sf x, edge (x > 1))) (\_ -> back (sf >>> arr (+ 1)))
    |                                                        ----------------------- `back` starts here, between two restarts
  3 | back sf = switch (proc x -> (sf x, edge (x < 1))) (\_ -> turn (sf &&& sf))
    |                                                          ^^^^^^^^^^^^^^^^ it restarts here, with one more `>>>`
    |
    = note: frobc must know all signal functions that can run, so their number must be finite
    = hint: restart it with the same signal functions each time; only numbers may change
  
  1 error
  [1]
  $ cat > larger.frob <<'FROB'
  > with :: a -> SF Float Float
  > with v = switch (proc x -> (x, edge (x > 1))) (\_ -> within (Just v))
  > 
  > within :: a -> SF Float Float
  > within v = switch (proc x -> (x, edge (x < 1))) (\_ -> with v)
  > 
  > main = with ()
  > FROB
  $ frobc check larger.frob
  error[E0417]: `within` restarts itself at a larger type
   --> larger.frob:2:54
    |
  2 | with v = switch (proc x -> (x, edge (x > 1))) (\_ -> within (Just v))
    |                                                      ^^^^^^ here its type variable becomes `Maybe a`
  ...
  5 | within v = switch (proc x -> (x, edge (x < 1))) (\_ -> with v)
    |                                                        ---- `within` starts `with` here
    |
    = hint: restart it with the same types
  
  1 error
  [1]

A definition has a copy for each signal function and type that it receives, and an option limits
their number.

  $ cat > copies.frob <<'FROB'
  > applied :: (Float -> Float) -> SF Float Float
  > applied f = proc x -> f (delay 0 x)
  > 
  > each :: SF Float Float
  > each = proc x -> applied sin x + applied (* 2) x + applied (\y -> y - 1) x
  > 
  > main = each
  > FROB
  $ frobc check copies.frob --specialization-limit 3
  $ frobc check copies.frob --specialization-limit 2
  error[E0413]: `applied` is specialized for more than 2 different arguments
   --> copies.frob:5:52
    |
  5 | each = proc x -> applied sin x + applied (* 2) x + applied (\y -> y - 1) x
    |                                                    ^^^^^^^^^^^^^^^^^^^^^^^ `applied` is called here
    |
    = note: frobc makes a separate copy for each combination of types, functions and signal functions in the arguments, but not for different numbers
    = hint: to allow more, use the option `--specialization-limit`
  
  1 error
  [1]
