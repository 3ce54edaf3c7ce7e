Values of events, and functions of them.

  $ cat > held.frob <<'FROB'
  > main :: SF Bool Bool
  > main = proc b -> hold False (edge b)
  > FROB
  $ frobc check held.frob
  error[E0301]: expected `Event Bool`, found `Event ()`
   --> held.frob:2:30
    |
  2 | main = proc b -> hold False (edge b)
    |                  ---- -----  ^^^^^^
    |                  |    |
    |                  |    because this is `Bool`
    |                  argument 2 of `hold` is `Event Bool`
    |
    = hint: the value of this event is `()`: for the value True, write `tag (edge b) True`
  
  1 error
  [1]

  $ cat > accumulated.frob <<'FROB'
  > main :: SF Bool Int
  > main = proc b -> accumHoldBy (\n -> n + 1) 0 (edge b)
  > FROB
  $ frobc check accumulated.frob
  error[E0301]: expected `a -> n[1]`, found a number
   --> accumulated.frob:2:37
    |
  2 | main = proc b -> accumHoldBy (\n -> n + 1) 0 (edge b)
    |                  -----------        ^^^^^
    |                  |
    |                  the result of argument 1 of `accumHoldBy` is `a -> n[1]`
    |
    = hint: the function receives one more argument: add a parameter, or `_` if you do not need it, as in `\n _ -> n + 1`
  
  1 error
  [1]

  $ cat > merged.frob <<'FROB'
  > main :: SF (Bool, Bool, Bool) Int
  > main = proc (a, b, c) -> count (mergeE (edge a) (edge b) (edge c))
  > FROB
  $ frobc check merged.frob
  error[E0302]: `mergeE` takes 2 arguments, but is given 3
   --> merged.frob:2:59
    |
  2 | main = proc (a, b, c) -> count (mergeE (edge a) (edge b) (edge c))
    |                                 ------                    ^^^^^^ one too many
    |                                 |
    |                                 with 2 arguments, its result is `Event ()`
    |
    = hint: for three values, write `mergeE (edge a) (mergeE (edge b) (edge c))`
  
  1 error
  [1]

  $ cat > rate.frob <<'FROB'
  > import Robot
  > rate = 10[Hz]
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = sampleEvery rate (proc j -> frontSonar j * 0.1[1/s]) i)
  > FROB
  $ frobc check rate.frob
  error[E0320]: expected the unit `s`, found `1/s`
   --> rate.frob:4:21
    |
  4 |     v = sampleEvery rate (proc j -> frontSonar j * 0.1[1/s]) i)
    |         ----------- ^^^^ this is `Float[1/s]`
    |         |
    |         argument 1 of `sampleEvery` is `Time` (s)
    |
    = hint: to convert between a rate and a time, write `(1 / rate)`
  
  1 error
  [1]
