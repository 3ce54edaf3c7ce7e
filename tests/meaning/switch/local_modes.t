Modes may form loops in a `where`, in a `let` and among the equations of a proc,
and use names of the enclosing definition.

  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ printf 'time,in\n0,0\n1,2\n2,-1\n3,4\n4,0\n5,1\n6,-2\n7,3\n' > in.csv

The modes capture a predicate and two signal functions, and start each other.

  $ cat > provided.frob <<'EOF'
  > provided :: (a -> Bool) -> SF a b -> SF a b -> SF a b
  > provided p yes no = initially (\x -> if p x then whileYes else whileNo) where
  >     whileYes = switch (proc x -> (yes x, edge (not (p x)))) (\_ -> whileNo)
  >     whileNo = switch (proc x -> (no x, edge (p x))) (\_ -> whileYes)
  > 
  > main :: SF Float Float
  > main = provided (\v -> v > 0) (delay 7) (arr (\v -> v * 2))
  > EOF
  $ both provided.frob in.csv
  time,out
  0.000000000,0
  1.000000000,7
  2.000000000,-2
  3.000000000,7
  4.000000000,0
  5.000000000,7
  6.000000000,-4
  7.000000000,7

In a `let`, with a computed number; nested, with the outer mode's parameter; in a proc, with its
constants; bound by a pattern; polymorphic, without and with a signature.

  $ cat > others.frob <<'EOF'
  > inLet :: SF Float Float
  > inLet = proc x ->
  >     let go n = switch (proc v -> (v + n, edge (v > 2))) (\_ -> go (n + 1))
  >         y = go 3 x
  >     in y + x
  > 
  > nested :: Float -> SF Float Float
  > nested k = outer 0 where
  >     outer n = switch (proc v -> (v + n, edge (v > 2))) (\_ -> inner 5) where
  >         inner m = switch (proc v -> (v * m + n, edge (v < 2)))
  >                          (\_ -> if m > k then outer (n + 1) else inner (m + 1))
  > 
  > inProc :: SF Float Float
  > inProc = proc x -> go 1 x where
  >     k = 2
  >     go n = switch (proc v -> (v * n + k, edge (v > k))) (\_ -> up (n * 2))
  >     up n = switch (proc v -> (v - n, edge (v < 0))) (\_ -> go (n + 1))
  > 
  > pair :: SF Float Float
  > pair = up where
  >     (up, down) = (switch (proc x -> (x, edge (x > 0))) (\_ -> down),
  >                   switch (proc x -> (0 - x, edge (x < 0))) (\_ -> up))
  > 
  > largest :: (a -> Bool) -> a -> SF a a
  > largest p first = go first where
  >     go v = switch (proc x -> (if p v then x else v, tag (edge (p x)) x)) go
  > 
  > poly :: SF Float (Float, Bool)
  > poly = proc x -> (go 0 x, go 1 (x > 1)) where
  >     go :: Int -> SF a a
  >     go n = switch (proc v -> (v, gate (notYet (every 2[s] ())) (n < 3))) (\_ -> go (n + 1))
  > 
  > main :: SF Float (Float, Float, Float, Float, Float, (Float, Bool))
  > main = inLet &&& nested 6 &&& inProc &&& pair &&& largest (\v -> v > 1) 9 &&& poly >>> arr flat
  > 
  > flat :: (a, (b, (c, (d, (e, f))))) -> (a, b, c, d, e, f)
  > flat (a, (b, (c, (d, (e, f))))) = (a, b, c, d, e, f)
  > EOF
  $ both others.frob in.csv
  time,out.1,out.2,out.3,out.4,out.5,out.6.1,out.6.2
  0.000000000,3,0,2,0,0,0,false
  1.000000000,7,2,4,-2,2,2,true
  2.000000000,1,-1,1,-1,-1,-1,false
  3.000000000,12,20,2,-4,4,4,true
  4.000000000,4,0,-2,0,0,0,false
  5.000000000,6,6,-1,-1,1,1,false
  6.000000000,0,-12,-4,-2,-2,-2,false
  7.000000000,11,18,-3,-3,3,3,true

A mode that mentions a signal is a closure: an event carries it, and it captures the signal at that
instant.

  $ cat > closure.frob <<'EOF'
  > main :: SF Float Float
  > main = proc x -> y where
  >     go n = switch (proc v -> (v + n + x, edge (v > 2))) (\_ -> go (n + 1))
  >     y = rSwitch (delay 0) (x, tag (edge (x > 1)) (go 1))
  > EOF
  $ both closure.frob in.csv
  time,out
  0.000000000,0
  1.000000000,5
  2.000000000,2
  3.000000000,9
  4.000000000,5
  5.000000000,6
  6.000000000,3
  7.000000000,7
  $ cat > instance.frob <<'EOF'
  > main :: SF Float Float
  > main = proc x -> z where
  >     go = let y = delay 0 x in \n -> switch (proc v -> (v + n + y, edge (v > 2))) (\_ -> go (n + 1))
  >     z = rSwitch (delay 0) (x, tag (edge (x > 1)) (go 1))
  > EOF
  $ both instance.frob in.csv
  time,out
  0.000000000,0
  1.000000000,3
  2.000000000,0
  3.000000000,4
  4.000000000,0
  5.000000000,1
  6.000000000,-2
  7.000000000,2
  $ cat > run.frob <<'EOF'
  > main :: SF Float Float
  > main = proc x -> go 0 x where
  >     go n = switch (proc v -> (v + n + x, edge (v > 2))) (\_ -> go (n + 1))
  > EOF
  $ frobc check run.frob
  error[E0340]: the signal function that runs here must be static, but `go` is a signal
   --> run.frob:2:18
    |
  2 | main = proc x -> go 0 x where
    |             -    ^^
    |             |
    |             `x` is a signal: it comes from the `proc`'s input here
  3 |     go n = switch (proc v -> (v + n + x, edge (v > 2))) (\_ -> go (n + 1))
    |                                       - `go` is a signal: it depends on `x` here
    |
    = hint: static values must be known when the signal function starts: pass a signal in its input, or use `initially` to start it with the first value of a signal
  
  1 error
  [1]

The rules for tail position are the same as at the top level.

  $ cat > nested.frob <<'EOF'
  > main :: SF Float Float
  > main = go 0 where
  >     go n = switch (proc v -> (v + n, edge (v > 2))) (\_ -> go 1 >>> arr (\x -> x + 1))
  > EOF
  $ frobc check nested.frob
  error[E0415]: `go` restarts itself inside itself
   --> nested.frob:3:60
    |
  3 |     go n = switch (proc v -> (v + n, edge (v > 2))) (\_ -> go 1 >>> arr (\x -> x + 1))
    |                                                            ^^^^^^^^^^^^^^^^^^^^^^^^^^ here, inside `>>>`
    |
    = note: a signal function may only restart itself as the whole result of a continuation; otherwise each restart would need more memory
    = hint: apply `>>>` once, where the first mode starts, not in each mode
  
  1 error
  [1]
  $ cat > grows.frob <<'EOF'
  > main :: SF Float Float
  > main = go (arr (\x -> x + 1)) where
  >     go sf = switch (proc v -> (sf v, edge (v > 2))) (\_ -> go (sf >>> sf))
  > EOF
  $ frobc check grows.frob
  error[E0416]: `go` grows each time it restarts itself
   --> grows.frob:3:60
    |
  3 |     go sf = switch (proc v -> (sf v, edge (v > 2))) (\_ -> go (sf >>> sf))
    |                                                            ^^^^^^^^^^^^^^ it restarts here, with one more `>>>`
    |
    = note: frobc must know all signal functions that can run, so their number must be finite
    = hint: restart it with the same signal functions each time; only numbers may change
  
  1 error
  [1]
  $ cat > circle.frob <<'EOF'
  > main :: SF Float Float
  > main = up 0 where
  >     up n = down (n + 1)
  >     down n = release n
  >     release n = up n
  > EOF
  $ frobc check circle.frob
  error[E0410]: `up` calls itself through other definitions
   --> circle.frob:3:5
    |
  3 |     up n = down (n + 1)
    |     ^^     ---- `up` uses `down` here
    |     |
    |     `up → down → release → up`
  4 |     down n = release n
    |              ------- `down` uses `release` here
  5 |     release n = up n
    |                 -- `release` uses `up` here
    |
    = note: functions cannot be recursive: use `foldl` or `scanl` to process an array; a signal function may only restart itself in the continuation of a switch
    = hint: for a value that depends on its own past, write an equation with `delay` in a `proc`, as in `n = delay 0 n + 1`
  
  1 error
  [1]
  $ cat > function.frob <<'EOF'
  > main :: SF Float Float
  > main = proc x -> f x where
  >     f n = if n > 0 then f (n - 1) else 0
  > EOF
  $ frobc check function.frob
  error[E0410]: `f` calls itself
   --> function.frob:3:5
    |
  3 |     f n = if n > 0 then f (n - 1) else 0
    |     ^                   - `f` uses `f` here
    |
    = note: functions cannot be recursive: use `foldl` or `scanl` to process an array; a signal function may only restart itself in the continuation of a switch
    = hint: for a value that depends on its own past, write an equation with `delay` in a `proc`, as in `n = delay 0 n + 1`
  
  1 error
  [1]
  $ cat > value.frob <<'EOF'
  > f :: Float -> Float
  > f x = y where
  >     y = g z + x
  >     g n = n
  >     z = y
  > main = arr f
  > EOF
  $ frobc check value.frob
  error[E0346]: `z` is used in its own definition
   --> value.frob:3:11
    |
  3 |     y = g z + x
    |           ^ only the equations of a `proc` may be recursive
  4 |     g n = n
  5 |     z = y
    |     - `z` is defined here
  
  1 error
  [1]
