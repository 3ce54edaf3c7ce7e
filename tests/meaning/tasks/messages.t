Expressions that are not tasks, tasks that do not fit together, and tasks used
as signal functions.

  $ cat > mistakes.frob <<'EOF'
  > wait :: Task Float Float Float
  > wait = do
  >     x <- snapT
  >     sleepT 1[s] 0
  >     2 * x
  > 
  > g :: Task Float Float Float
  > g = do
  >     x <- derivative
  >     sleepT 1[s]
  >     4
  >     return x
  > 
  > h = proc x -> y where
  >    y = g x
  > h2 :: SF Float Float
  > h2 = g
  > h3 :: SF Float Float
  > h3 = switch (constant (1, NoEvent)) (\_ -> g)
  > 
  > i :: Bool -> Task Float Float ()
  > i b = if b then return 1[m] else sleepT 1[s] 2
  > j b = if b then sleepT 1[s] 2 else return 1[m]
  > k = do
  >    sleepT 1[s] 2
  >    sleepT 1[s] True
  >    return ()
  > l = do
  >    Just x <- return Nothing
  >    return x
  > m :: SF Float (Event ())  -> Task Float Float (Either () ())
  > m sf = timeOut sf 2[s]
  > EOF
  $ frobc check mistakes.frob
  error[E0370]: each statement in a `do` must be a task, but this is `Float`
   --> mistakes.frob:5:5
    |
  1 | wait :: Task Float Float Float
    |         ---------------------- the signature of `wait` requires `Task Float Float Float`
  ...
  5 |     2 * x
    |     ^^^^^
    |
    = hint: use `let x = …` to name a value, or `return x` for a task that returns it immediately
  
  error[E0371]: expected a task, found a signal function
   --> mistakes.frob:9:10
    |
  7 | g :: Task Float Float Float
    |      ---------------------- each task of this `do` must be `Task Float Float a`
  8 | g = do
  9 |     x <- derivative
    |          ^^^^^^^^^^ this is `SF Float[u] Float[u/s]`
    |
    = hint: to read it once, write `ask derivative`
    = hint: to run it for a fixed time, write `mkTask (derivative &&& after 5[s])`; to run it forever, `mkTask (derivative &&& never)`
  
  error[E0301]: `sleepT` lacks its last argument, the output during that time
    --> mistakes.frob:10:5
     |
   7 | g :: Task Float Float Float
     |      ---------------------- each task of this `do` must be `Task Float Float a`
  ...
  10 |     sleepT 1[s]
     |     ^^^^^^^^^^^
     |
     = hint: add an output: `sleepT 1[s] restingOutput` waits with the robot at rest
  
  error[E0370]: each statement in a `do` must be a task, but this is a number
    --> mistakes.frob:11:5
     |
   7 | g :: Task Float Float Float
     |      ---------------------- each task of this `do` must be `Task Float Float a`
  ...
  11 |     4
     |     ^
     |
     = hint: use `let x = …` to name a value, or `return x` for a task that returns it immediately
  
  error[E0302]: `g` is `Task Float Float Float`, not a function
    --> mistakes.frob:15:8
     |
  15 |    y = g x
     |        ^ - it is applied to an argument here
     |
     = hint: a `proc` cannot run a task, because a task takes time: compute a value here, or run `g` in a `do`, as in `main = reactimateTask (do …)`
  
  error[E0371]: expected a signal function, found a task
    --> mistakes.frob:17:6
     |
  16 | h2 :: SF Float Float
     |       -------------- the signature of `h2` requires `SF Float Float`
  17 | h2 = g
     |      ^ this is `Task Float Float Float`
     |
     = hint: use `runTask g`, a signal function that returns `Left` with the output while the task runs, then `Right` with the result
  
  error[E0371]: expected a signal function, found a task
    --> mistakes.frob:19:44
     |
  19 | h3 = switch (constant (1, NoEvent)) (\_ -> g)
     |      ------                                ^ this is `Task Float Float Float`
     |      |
     |      argument 2 of `switch` is `SF a n[1]`
     |
     = hint: `switch` continues with a signal function: to continue with a task, use a `do` instead, with `mkTask (…)` around the first argument of `switch` on its first line and `g` on its second; `reactimateTask` turns the `do` into a program
  
  error[E0301]: expected a task that returns `()`, but this one returns a number in `m`
    --> mistakes.frob:22:17
     |
  21 | i :: Bool -> Task Float Float ()
     |      --------------------------- the signature of `i` requires `Task Float Float ()`
  22 | i b = if b then return 1[m] else sleepT 1[s] 2
     |                 ^^^^^^^^^^^
     |
     = hint: to drop the result of this task, write `mapT (const ()) (return 1[m])`; in a `do`, you can also write `return ()` below it
  
  error[E0301]: expected a task that returns `()`, but this one returns a number in `m`
    --> mistakes.frob:23:36
     |
  23 | j b = if b then sleepT 1[s] 2 else return 1[m]
     |                 -------------      ^^^^^^^^^^^
     |                 |
     |                 this branch is `Task a n[1] ()`
     |
     = hint: to drop the result of this task, write `mapT (const ()) (return 1[m])`; in a `do`, you can also write `return ()` below it
  
  error[E0301]: expected a task with the output a number, but this one has the output `Bool`
    --> mistakes.frob:26:4
     |
  25 |    sleepT 1[s] 2
     |    ------------- each task of this `do` must be `Task a n[1] b`
  26 |    sleepT 1[s] True
     |    ^^^^^^^^^^^^^^^^
  
  error[E0371]: expected a task, found a signal function
    --> mistakes.frob:32:16
     |
  32 | m sf = timeOut sf 2[s]
     |        ------- ^^ this is `SF Float (Event ())`
     |        |
     |        argument 1 of `timeOut` is `Task a b c`
     |
     = hint: to run it for a fixed time, write `mkTask (sf &&& after 5[s])`; to run it forever, `mkTask (sf &&& never)`
  
  11 errors
  [1]

A pattern before `<-` must always match, and a task must not mention a signal or contain an
instance.

  $ cat > patterns.frob <<'EOF'
  > whole :: Task a Float Int
  > whole = do
  >     Just x <- return Nothing
  >     return x
  > 
  > static :: SF Float (Either Float ())
  > static = proc x -> runTask t () where
  >     t = sleepT 1[s] x
  > 
  > inside :: SF Float (Either Float ())
  > inside = proc x -> runTask t () where
  >     t = do
  >         y <- snapT
  >         constT (derivative x / 1[1/s])
  > 
  > outside :: SF Float Float -> Task Float Float ()
  > outside sf = do
  >     y <- snapT
  >     sleepT 1[s] (sf y)
  > EOF
  $ frobc check patterns.frob
  error[E0351]: the pattern of a `<-` must match every value
   --> patterns.frob:3:5
    |
  3 |     Just x <- return Nothing
    |     ^^^^^^ does not match `Nothing`
    |
    = hint: use a `case`, with a branch for `Nothing` too
  
  error[E0344]: `t` is a task and must be static, but `x` is a signal
   --> patterns.frob:8:21
    |
  7 | static = proc x -> runTask t () where
    |               - `x` is a signal: it comes from the `proc`'s input here
  8 |     t = sleepT 1[s] x
    |                     ^
    |
    = hint: pass values that are known at the start as parameters of the task, and signals in its input
  
  error[E0343]: `derivative` is run in a function
    --> patterns.frob:14:17
     |
  14 |         constT (derivative x / 1[1/s])
     |                 ^^^^^^^^^^^^ a function cannot run a signal function, because a signal function has state: run it in a `proc`
     |
     = hint: to run it at every instant, add the equation `derivativeNow = derivative x`, and write `derivativeNow` here
  
  error[E0344]: `t` is a task and must be static, but `x` is a signal
    --> patterns.frob:14:28
     |
  11 | inside = proc x -> runTask t () where
     |               - `x` is a signal: it comes from the `proc`'s input here
  ...
  14 |         constT (derivative x / 1[1/s])
     |                            ^
     |
     = hint: pass values that are known at the start as parameters of the task, and signals in its input
  
  error[E0341]: `sf` is run outside of a `proc`
    --> patterns.frob:19:18
     |
  19 |     sleepT 1[s] (sf y)
     |                  ^^^^ the statements of a task cannot run signal functions
     |
     = hint: to read it once, write `x <- ask sf` before this, and `x` here
     = hint: to run it at every instant of a task, write `mkTask (proc i -> (output, event))`
  
  5 errors
  [1]

A program is not a task, but a signal function that runs one.

  $ printf 'main :: Task Float Float ()\nmain = sleepT 1[s] 2\n' > entry.frob
  $ frobc compile entry.frob
  error[E0411]: `main` cannot run: it is a task, `Task Float Float ()`, not a signal function
   --> entry.frob:2:1
    |
  2 | main = sleepT 1[s] 2
    | ^^^^^^^^^^^^^^^^^^^^
    |
    = hint: use `runTask main` for a signal function, or `reactimateTask main` for a robot program
  
  1 error
  [1]

Arguments in the wrong order: a time instead of a task, or the reverse.

  $ cat > order.frob <<'EOF'
  > follow :: Task Float Float ()
  > follow = mkTask (proc x -> (x, edge (x > 1)))
  > 
  > a, b, c, d :: Task Float Float Bool
  > a = mapT (maybe False (const True)) (timeOut 3[s] follow)
  > b = mapT (maybe False (const True)) (3[s] `timeOut` follow)
  > c = mapT (maybe False (const True)) (timeOut 3[s])
  > d = mapT (maybe False (const True)) (timeOut follow follow)
  > 
  > e :: Task Float Float (Maybe ())
  > e = retryT (mapT Just follow) 3
  > EOF
  $ frobc check order.frob
  error[E0301]: the arguments of `timeOut` are in the wrong order
   --> order.frob:5:38
    |
  5 | a = mapT (maybe False (const True)) (timeOut 3[s] follow)
    |                                      ^^^^^^^^^^^^^^^^^^^
    |
    = hint: write `timeOut follow 3[s]`
  
  error[E0301]: the arguments of `timeOut` are in the wrong order
   --> order.frob:6:38
    |
  6 | b = mapT (maybe False (const True)) (3[s] `timeOut` follow)
    |                                      ^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: write `timeOut follow 3[s]`
  
  error[E0301]: `timeOut` lacks an argument before `3[s]`
   --> order.frob:7:46
    |
  7 | c = mapT (maybe False (const True)) (timeOut 3[s])
    |                                      ------- ^^^^
    |                                      |
    |                                      `timeOut :: Task a b c -> Time -> Task a b (Maybe c)`
  
  error[E0301]: expected `Time` (s), found `Task Float Float ()`
   --> order.frob:8:53
    |
  8 | d = mapT (maybe False (const True)) (timeOut follow follow)
    |                                      -------        ^^^^^^
    |                                      |
    |                                      argument 2 of `timeOut` is `Time` (s)
    |
    = hint: the signature is `timeOut :: Task a b c -> Time -> Task a b (Maybe c)`
  
  error[E0301]: the arguments of `retryT` are in the wrong order
    --> order.frob:11:5
     |
  11 | e = retryT (mapT Just follow) 3
     |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^
     |
     = hint: write `retryT 3 (mapT Just follow)`
  
  5 errors
  [1]
