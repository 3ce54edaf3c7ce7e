A function computed from signals exists for one instant. If it would be stored, the message shows
how it gets there, with the call in the program first.

  $ cat > held.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> f x where
  >     f = hold id (Event (\y -> y + x))
  > FROB
  $ check() { frobc check "$1" 2>&1 | sed 's/Prelude.frob:[0-9]*/Prelude.frob:N/; s/^[0-9][0-9][0-9] /  N /'; }
  $ check held.frob
  error[E0412]: `hold` cannot keep a value of type `Float -> Float`
     --> held.frob:3:5
      |
    3 |     f = hold id (Event (\y -> y + x))
      |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
      |
     ::: stdlib/Prelude.frob:N:20
      |
    N |     y = fromEvent (delay x0 y) e
      |                    ---------- this `delay` would store it
      |
      = note: functions, signal functions and labels only exist at compile time
  
  1 error
  $ cat > best.frob <<'FROB'
  > main :: SF (Float, Float) Float
  > main = proc (x, y) -> best x where
  >     best = atMin (\z -> z * x, y)
  > FROB
  $ check best.frob
  error[E0412]: `atMin` cannot keep a value of type `Maybe (Float -> Float, Float)`
     --> best.frob:3:5
      |
    3 |     best = atMin (\z -> z * x, y)
      |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
      |
     ::: stdlib/Prelude.frob:N:5
      |
    N |     before = delay Nothing (Just (best, bestKey))
      |     --------------------------------------------- this `delay` would store it
      |
      = note: functions, signal functions and labels only exist at compile time
  
  1 error
  $ cat > own.frob <<'FROB'
  > keep :: a -> SF (Event a) a
  > keep x0 = proc e -> z where
  >     z = fromEvent (delay x0 z) e
  > wrap :: (Float -> Float) -> SF (Event (Float -> Float), Float) Float
  > wrap f0 = proc (e, x) -> g x where
  >     pair = (x, keep f0 e)
  >     g = snd pair
  > main :: SF Float Float
  > main = proc x -> wrap id (mapE (\_ y -> x + y) (edge (x > 1)), x)
  > FROB
  $ frobc check own.frob
  error[E0412]: a value of type `Float -> Float` cannot be stored in a `delay`
   --> own.frob:3:20
    |
  3 |     z = fromEvent (delay x0 z) e
    |                    ^^^^^^^^^^
  ...
  6 |     pair = (x, keep f0 e)
    |                --------- `keep` is called here
  ...
  9 | main = proc x -> wrap id (mapE (\_ y -> x + y) (edge (x > 1)), x)
    |                  ------------------------------------------------ `wrap` is called here
    |
    = note: functions, signal functions and labels only exist at compile time
  
  1 error
  [1]

The running signal function is chosen when it starts; a signal cannot be its
parameter.

  $ cat > parameter.frob <<'FROB'
  > import Control
  > main :: SF (Float, Float) Float
  > main = proc (x, tau) -> lowPass (tau * 1[s]) x
  > FROB
  $ frobc check parameter.frob
  error[E0340]: the arguments of `lowPass` before its signal must be static, but `tau` is a signal
   --> parameter.frob:3:34
    |
  3 | main = proc (x, tau) -> lowPass (tau * 1[s]) x
    |                 ---              ^^^
    |                 |
    |                 `tau` is a signal: it comes from the `proc`'s input here
    |
    = hint: a static value must be known when the signal function starts: run one signal function for each of a few constant settings and choose between their outputs, pass the signal in the input, or use `initially` to keep its first value
  
  1 error
  [1]

An array of functions is rejected wherever a function would be: in stored values, and in the input
or the output of the program.

  $ cat > stored.frob <<'FROB'
  > main :: SF (Float, Int) Float
  > main = proc (x, i) -> at i id fs 2 where
  >     fs = delay [abs, negate] [\y -> y + x, negate]
  > FROB
  $ frobc check stored.frob
  error[E0412]: a value of type `Array 2 (Float -> Float)` cannot be stored in a `delay`
   --> stored.frob:3:5
    |
  3 |     fs = delay [abs, negate] [\y -> y + x, negate]
    |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: functions, signal functions and labels only exist at compile time
  
  1 error
  [1]
  $ cat > made.frob <<'FROB'
  > main :: SF (Array 3 Float, Int) (Float, Int)
  > main = proc (xs, i) -> (at i id (fst last) 2, snd last) where
  >     last = hold ([id, id, id], 0) (tag (edge (i > 0)) (map (\x y -> x * y) xs, i))
  > FROB
  $ check made.frob
  error[E0412]: `hold` cannot keep a value of type `(Array 3 (Float -> Float), Int)`
     --> made.frob:3:5
      |
    3 |     last = hold ([id, id, id], 0) (tag (edge (i > 0)) (map (\x y -> x * y) xs, i))
      |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
      |
     ::: stdlib/Prelude.frob:N:20
      |
    N |     y = fromEvent (delay x0 y) e
      |                    ---------- this `delay` would store it
      |
      = note: functions, signal functions and labels only exist at compile time
  
  1 error
  $ cat > output.frob <<'FROB'
  > main :: SF Float (Maybe (Array 2 (Float -> Float)))
  > main = proc x -> Just (generate (\_ y -> y + x))
  > FROB
  $ frobc check output.frob
  error[E0412]: the output of `main` cannot be of type `Maybe (Array 2 (Float -> Float))`
   --> output.frob:2:1
    |
  2 | main = proc x -> Just (generate (\_ y -> y + x))
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: functions, signal functions and labels only exist at compile time
  
  1 error
  [1]
  $ cat > run.frob <<'FROB'
  > main :: SF (Array 3 Float) Float
  > main = proc xs -> foldl (>>>) identity (map (\x -> arr (\y -> x * y)) xs) 2
  > FROB
  $ frobc check run.frob
  error[E0340]: the arguments of `foldl` before its signal must be static, but `xs` is a signal
   --> run.frob:2:71
    |
  2 | main = proc xs -> foldl (>>>) identity (map (\x -> arr (\y -> x * y)) xs) 2
    |             --                                                        ^^
    |             |
    |             `xs` is a signal: it comes from the `proc`'s input here
    |
    = hint: a static value must be known when the signal function starts: run one signal function for each of a few constant settings and choose between their outputs, pass the signal in the input, or use `initially` to keep its first value
  
  1 error
  [1]
  $ cat > grows.frob <<'FROB'
  > main :: SF (Float, Int) Float
  > main = go [id, negate]
  > go :: Array 2 (Float -> Float) -> SF (Float, Int) Float
  > go fs = switch (proc (x, i) -> (at i id fs x, tag (edge (i > 1)) (map (\f y -> f (x + y)) fs))) go
  > FROB
  $ frobc check grows.frob
  error[E0416]: `go` grows each time it restarts itself
   --> grows.frob:4:9
    |
  4 | go fs = switch (proc (x, i) -> (at i id fs x, tag (edge (i > 1)) (map (\f y -> f (x + y)) fs))) go
    |         ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ it restarts here, with one more `go`
    |
    = note: frobc must know all signal functions that can run, so their number must be finite
    = hint: restart it with the same signal functions each time; only numbers may change
  
  1 error
  [1]
