A short program can require endless work. Each stage counts its steps (not the time), reports what
grows when the limit is reached, and has the same result on every machine. So this test shows
messages that contain the counts, and does not depend on the clock.

  $ refused() { cat > "$1.frob"; timeout 100 frobc check "$1.frob" 2>&1 | cut -c 1-140; }

A signal function that is chosen at each start nests one `if` deeper each time:

  $ refused chosen <<'EOF'
  > lowp :: SF Float Float
  > lowp = proc x -> delay 0 x
  > 
  > g :: SF Float Float -> Int -> SF Float Float
  > g sf n = switch (proc x -> (y, tag (edge (y > 10)) n) where y = sf x) (\k -> g (if k > 3 then lowp else sf) (k + 1))
  > 
  > main :: SF Float Float
  > main = g (delay 1) 0
  > EOF
  error[E0416]: `g` grows each time it restarts itself
   --> chosen.frob:5:78
    |
  5 | g sf n = switch (proc x -> (y, tag (edge (y > 10)) n) where y = sf x) (\k -> g (if k > 3 then lowp else sf) (k + 1))
    |                                                                              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ it restarts here, wi
    |
    = note: frobc must know all signal functions that can run, so their number must be finite
    = hint: restart it with the same signal functions each time; only numbers may change
    = hint: pass the condition of the `if` as an argument, and choose inside `g`
  
  1 error

An array of a million signal functions, and of a thousand times a thousand functions:

  $ refused parallel <<'EOF'
  > main :: SF Float Float
  > main = proc x -> foldl (+) 0 (parB sfs x) where
  >     sfs = (generate (\_ -> delay 0) :: Array 1048576 (SF Float Float))
  > EOF
  error[E0413]: an array of 1048576 functions or signal functions is too large to compile
   --> parallel.frob:3:12
    |
  3 |     sfs = (generate (\_ -> delay 0) :: Array 1048576 (SF Float Float))
    |            ^^^^^^^^^^^^^^^^^^^^^^^^ `generate` needs a separate copy of each element here
    |
    = note: an array of numbers is computed in a loop, but each function or signal function in an array gets its own code
    = hint: make the array shorter, or run one signal function on an array of numbers: `mapSF f xs`
  
  1 error
an array of   error[E0413]: 1048576 functions or signal functions is too large to compile
  $ refused square <<'EOF'
  > main :: SF Float Float
  > main = proc x -> foldl (\y row -> foldl (\z f -> f z) y row) x fs where
  >     fs = (generate (\_ -> generate (\_ -> step)) :: Array 1000 (Array 1000 (Float -> Float)))
  >     step y = y + 1
  > EOF
  error[E0413]: an array of 1000 times 1000 functions or signal functions is too large to compile
   --> square.frob:3:27
    |
  3 |     fs = (generate (\_ -> generate (\_ -> step)) :: Array 1000 (Array 1000 (Float -> Float)))
    |           ----------------^^^^^^^^^^^^^^^^^^^^^-
    |           |               |
    |           |               `generate` needs a separate copy of each element here
    |           `main` is called here
    |
    = note: an array of numbers is computed in a loop, but each function or signal function in an array gets its own code
    = hint: make the array shorter, or run one signal function on an array of numbers: `mapSF f xs`
  
  1 error
an array of   error[E0413]: 1000 times 1000 functions or signal functions is too large to compile

Tasks that run another task twice, on twenty levels; modes whose signal functions change in all
combinations:

  $ { echo 'main :: SF Float (Either Float ())'; echo 'main = runTask t20'; echo 't0 :: Task Float Float ()'
  >   echo 't0 = mkTask (proc x -> (x, edge (x > 1)))'
  >   for i in $(seq 20); do printf 't%d = do\n    t%d\n    t%d\n' $i $((i - 1)) $((i - 1)); done; } | refused twice
  error[E0413]: `t0` is specialized for more than 10000 different arguments
    --> twice.frob:19:5
     |
   2 | main = runTask t20
     | ------------------ `t20` is called here
  ...
  19 |     t4
     |     ^^
     |
     = note: the state machine of `t20` already has 10000 modes: one for each combination of a task or signal function and everything that can
     = hint: repeat a task with `repeatT n`, `whileT` or `forever`, which use one mode for all repetitions
     = hint: to allow more, use the option `--specialization-limit`
  
  1 error
  $ list() { for i in $(seq 0 13); do printf "$1" $i; done; }
  $ next() { for i in $(seq 0 13); do if [ $i = $1 ]; then printf ' b'; else printf ' s%d' $i; fi; done; }
  $ branches() { for j in $(seq 0 13); do printf 'if v > %d then go%s else ' $j "$(next $j)"; done; }
  $ { printf 'a, b :: SF Float Float\na = delay 1\nb = delay 2 >>> delay 3\n'
  >   printf 'go :: %sSF (Float, Bool) Float\n' "$(list 'SF Float Float -> ')"
  >   printf 'go %s= switch (proc (x, e) -> (s0 x, tag (edge e) x)) (\\v -> %s s0 <<< arr fst)\n' "$(list 's%d ')" "$(branches)"
  >   printf 'main :: SF (Float, Bool) Float\nmain = go %s\n' "$(list 'a ')"; } | refused combinations | head -1
  error[E0413]: the state machine of `go` has too many modes: more than 5452

Functions that call the next one twice, with other functions; signal functions with other numbers;
types that double:

  $ { echo 'h0 :: (Float -> Float) -> Float -> Float'; echo 'h0 f x = f x'
  >   for i in $(seq 18); do printf 'h%d :: (Float -> Float) -> Float -> Float\n' $i
  >     printf 'h%d f x = h%d (\\y -> f (y + 1)) x + h%d (\\y -> f (y * 2)) x\n' $i $((i - 1)) $((i - 1)); done
  >   echo 'main :: SF Float Float'; echo 'main = arr (h18 (\x -> x + 1))'; } | refused higher
  error[E0413]: `h1` is specialized for more than 10000 different arguments
    --> higher.frob:2:10
     |
   2 | h0 f x = f x
     |          ^^^ `h1` is called here
   3 | h1 :: (Float -> Float) -> Float -> Float
   4 | h1 f x = h0 (\y -> f (y + 1)) x + h0 (\y -> f (y * 2)) x
     |                                   ---------------------- `h0` is called here
   5 | h2 :: (Float -> Float) -> Float -> Float
   6 | h2 f x = h1 (\y -> f (y + 1)) x + h1 (\y -> f (y * 2)) x
     |                                   ---------------------- `h1` is called here
   7 | h3 :: (Float -> Float) -> Float -> Float
   8 | h3 f x = h2 (\y -> f (y + 1)) x + h2 (\y -> f (y * 2)) x
     |          ---------------------- `h2` is called here
   9 | h4 :: (Float -> Float) -> Float -> Float
  10 | h4 f x = h3 (\y -> f (y + 1)) x + h3 (\y -> f (y * 2)) x
     |                                   ---------------------- `h3` is called here
     |
     = note: frobc makes a separate copy for each combination of types, functions and signal functions in the arguments, but not for different
     = hint: to allow more, use the option `--specialization-limit`
  
  1 error
  $ { echo 's0 :: Float -> SF Float Float'; echo 's0 k = delay k'
  >   for i in $(seq 20); do printf 's%d k = s%d (k + 1) >>> s%d (k + 2)\n' $i $((i - 1)) $((i - 1)); done
  >   echo 'main :: SF Float Float'; echo 'main = s20 1'; } | refused numbers
  error[E0413]: compiling takes too much work: `s0` is called more than 794901 times at compile time
    --> numbers.frob:24:1
     |
   3 | s1 k = s0 (k + 1) >>> s0 (k + 2)
     |        -- `s0` is called here
   4 | s2 k = s1 (k + 1) >>> s1 (k + 2)
     |                       ---------- `s1` is called here
   5 | s3 k = s2 (k + 1) >>> s2 (k + 2)
     |        ---------- `s2` is called here
   6 | s4 k = s3 (k + 1) >>> s3 (k + 2)
     |                       ---------- `s3` is called here
   7 | s5 k = s4 (k + 1) >>> s4 (k + 2)
     |        ---------- `s4` is called here
  ...
  24 | main = s20 1
     | ^^^^^^^^^^^^
     |
     = note: frobc evaluates a call at compile time if its result or an argument is a function or signal function; if each function calls the 
     = hint: nest the calls less deeply, or name a result and use the name twice instead of repeating the call
  
  1 error
  $ { echo 'f0 :: a -> Float'; echo 'f0 _ = 1'
  >   for i in $(seq 30); do printf 'f%d :: a -> Float\nf%d x = f%d (x, x)\n' $i $i $((i - 1)); done
  >   echo 'main :: SF Float Float'; echo 'main = proc x -> f30 x'; } | refused types
  error[E0316]: a value of a tuple would contain more than 20000 numbers
    --> types.frob:64:1
     |
  34 | f16 x = f15 (x, x)
     |         --- `f15` is called here
  35 | f17 :: a -> Float
  36 | f17 x = f16 (x, x)
     |         ---------- `f16` is called here
  37 | f18 :: a -> Float
  38 | f18 x = f17 (x, x)
     |         ---------- `f17` is called here
  39 | f19 :: a -> Float
  40 | f19 x = f18 (x, x)
     |         ---------- `f18` is called here
  41 | f20 :: a -> Float
  42 | f20 x = f19 (x, x)
     |         ---------- `f19` is called here
  ...
  64 | main = proc x -> f30 x
     | ^^^^^^^^^^^^^^^^^^^^^^
     |
     = hint: use an array for many values of one type: `Array 1000 Float`
  
  1 error

Small code with a large state: forty nested levels of a signal function.

  $ { echo 's0 = delay 0'; for i in $(seq 40); do echo "s$i = s$((i - 1)) >>> s$((i - 1))"; done
  >   echo 'main :: SF Float Float'; echo 'main = s40'; } | refused state
  error[E0413]: the program would store 1.1e+12 values from one instant to the next; the maximum is 134217728
     --> state.frob:43:1
      |
   43 | main = s40
      | ^^^^^^^^^^
      |
     ::: stdlib/Prelude.frob:252:26
      |
  252 | (>>>) f g = proc x -> g (f x)
      |                          --- `>>>` contains 2 of `>>>`
      |
      = note: each use of a signal function has its own copy of the state, including the state of all signal functions inside it
      = hint: to run a signal function only once, name its output in an equation, and use that name wherever you need the output
  
  1 error

Types that need a few lines but are larger than memory, in each place where types are written or
inferred:

  $ levels() { for i in $(seq $1); do printf "$2" $i $((i - 1)) $((i - 1)); done; }
  $ { echo 'x0 = 1'; levels 24 'x%d = (x%d, x%d)\n'; printf 'main :: SF Float Float\nmain = proc x -> x\n'; } | refused pairs | head -1
  error[E0316]: the type of this expression is too large
  $ { echo 'f0 x = (x, x)'; levels 8 'f%d x = f%d (f%d x)\n'; printf 'main :: SF Float Float\nmain = proc x -> x\n'; } | refused functions | head -1
  error[E0316]: the type of this expression is too large
  $ { echo 'type T0 a = (a, a)'; levels 7 'type T%d a = T%d (T%d a)\n'; printf 'main :: SF (T7 Float) Float\nmain = proc _ -> 1\n'; } | refused aliases | head -1
  error[E0316]: the type of `T5` is too large
  $ { echo 'data T0 = T0 Float Float'; for i in $(seq 24); do echo "data T$i = T$i T$((i - 1)) T$((i - 1))"; done
  >   printf 'main :: SF T24 Float\nmain = proc _ -> 1\n'; } | refused data
  error[E0316]: a value of the type `T14` would contain more than 20000 numbers
    --> data.frob:27:1
     |
  27 | main = proc _ -> 1
     | ^^^^^^^^^^^^^^^^^^
     |
     = hint: use an array for many values of one type: `Array 1000 Float`
  
  1 error
  $ { echo 'f0 y = y * y'; levels 63 'f%d y = f%d y * f%d y\n'; printf 'main :: SF Float Float\nmain = proc x -> f63 x\n'; } | refused units | head -1
  error[E0323]: the exponent of a unit is too large
  $ { cat <<'EOF'
  > class Size a where
  >     size :: a -> Float
  > data One = One
  > instance Size One where
  >     size _ = 1
  > data Pair a b = Pair a b
  > instance (Size a, Size b) => Size (Pair a b) where
  >     size (Pair a b) = size a + size b
  > f0 x = size x
  > EOF
  >   for i in $(seq 40); do echo "f$i x = f$((i - 1)) (Pair x x)"; done; printf 'main :: SF Float Float\nmain = proc _ -> f40 One\n'; } | refused classes | head -1
  error[E0413]: `f26` uses itself at ever larger types

Patterns with too many combinations. A last branch for everything makes them complete:

  $ patterns() { for i in $(seq 0 19); do printf '    ('; for j in $(seq 0 19); do
  >     if [ $i = $j ]; then printf R; elif [ $j = $(((i + 1) % 20)) ]; then printf G; else printf _; fi
  >     if [ $j -lt 19 ]; then printf ', '; fi; done; printf ') -> %d\n' $i; done; }
  $ colours=$(for i in $(seq 19); do printf 'C, '; done)C
  $ { echo 'data C = R | G | B'; echo "main :: SF ($colours) Float"; echo 'main = proc c -> case c of'; patterns; } > cases.frob
  $ refused patterns < cases.frob
  error[E0413]: this `case` is too complex to check for missing branches
   --> patterns.frob:3:23
    |
  3 | main = proc c -> case c of
    |                       ^
    |
    = note: its patterns have too many combinations
    = hint: add a last branch `_ -> …`, or split this `case` into nested `case` expressions
  
  1 error
  $ { cat cases.frob; echo '    _ -> 20'; } | refused complete

The interpreter computes parameters before the run:

  $ { echo 'param p :: Float = f40 1'; echo 'f0 :: Float -> Float'; echo 'f0 x = x + 1'; levels 40 'f%d x = f%d (f%d x)\n'
  >   printf 'main :: SF Float Float\nmain = proc x -> x + p\n'; } | refused parameter
  error[E0413]: the value of the parameter `p` takes too long to compute
   --> parameter.frob:1:20
    |
  1 | param p :: Float = f40 1
    |                    ^^^^^
    |
    = note: frobc computes it at compile time
    = hint: write the value as a literal, or compute it in the program from simpler parameters
  
  1 error
  $ refused folds <<'EOF'
  > param p :: Float = f 1
  > 
  > f :: Float -> Float
  > f a = foldl (\s _ -> s + foldl (\t _ -> t + foldl (\u _ -> u + 1) 0 xs) 0 xs) a xs where
  >     xs = (generate id :: Array 10000 Int)
  > 
  > main :: SF Float Float
  > main = proc x -> x + p
  > EOF
  error[E0413]: the value of the parameter `p` takes too long to compute
   --> folds.frob:1:20
    |
  1 | param p :: Float = f 1
    |                    ^^^
    |
    = note: frobc computes it at compile time
    = hint: write the value as a literal, or compute it in the program from simpler parameters
  
  1 error

A literal of 5 MB:

  $ { printf 'main :: SF Float Float\nmain = proc x -> x + at 3 0 [1'; awk 'BEGIN { for (i = 0; i < 1700000; i++) printf ", %d", i % 10; print "]" }'; } | refused literal | head -1
  error[E0333]: an array literal can have at most 100000 elements, not 1700001
  $ { printf 'main :: SF Float Float\nmain = proc x -> x + 0.'; awk 'BEGIN { for (i = 0; i < 500000; i++) printf "0123456789"; print "" }'; } | refused digits | head -1
  error[E0105]: a number has at most 1000 characters, but this one has 5000002

Long or deep programs that do not grow are compiled: seven nested loops of tasks, with 900
iterations each, an array of 20,000 signal functions, and 60 modes that all lead to each other.

  $ refused rounds <<'EOF'
  > main :: SF Float (Either Float ())
  > main = runTask (repeatT 900 (repeatT 900 (repeatT 900 (repeatT 900 (repeatT 900 (repeatT 900 (repeatT 900 step)))))))
  > 
  > step :: Task Float Float ()
  > step = mkTask (proc x -> (x, edge (x > 1)))
  > EOF
  $ refused many <<'EOF'
  > main :: SF Float Float
  > main = proc x -> foldl (+) 0 (parB sfs x) where
  >     sfs = (generate (\_ -> delay 0 >>> delay 1) :: Array 20000 (SF Float Float))
  > EOF
  $ { echo 'main :: SF Float Float'; echo 'main = m0 0'
  >   for i in $(seq 0 59); do echo "m$i :: Float -> SF Float Float"
  >     printf 'm%d k = switch (proc x -> (x + k, tag (edge (x > %d)) x)) (\\v -> ' $i $i
  >     for j in $(seq 0 59); do printf 'if v > %d then m%d v else ' $j $j; done; echo 'm0 v)'; done; } | refused modes
