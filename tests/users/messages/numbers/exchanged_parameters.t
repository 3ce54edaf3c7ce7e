Functions whose parameters are in the other order than the one in which `foldl` and `accumHoldBy`
pass them. The test applies each fix.

  $ cat > counter.frob <<'FROB'
  > data Step = Up | Down
  > move :: Step -> Int -> Int
  > move s n = case s of
  >     Up   -> n + 1
  >     Down -> n - 1
  > main :: SF (Event Step) Int
  > main = proc e -> accumHoldBy move 0 e
  > FROB
  $ frobc check counter.frob
  error[E0301]: the parameters of `move` are in the wrong order
   --> counter.frob:7:30
    |
  7 | main = proc e -> accumHoldBy move 0 e
    |                  ----------- ^^^^ this is `Step -> Int -> Int`
    |                  |
    |                  `accumHoldBy` passes the current value first, then the value of the event
    |
    = hint: write `(\n s -> move s n)`
  
  1 error
  [1]
  $ frobc fix --all counter.frob > /dev/null 2>&1; tail -1 counter.frob; frobc check counter.frob
  main = proc e -> accumHoldBy (\n s -> move s n) 0 e

  $ cat > others.frob <<'FROB'
  > data Step = Up | Down
  > move :: Step -> Int -> Int
  > move s n = if s == Up then n + 1 else n
  > longer :: Time -> Distance -> Distance
  > longer t d = d + t * 1[m/s]
  > total :: Array 3 Time -> Distance
  > total ts = foldl longer 0[m] ts
  > moved :: Array 3 Step -> Array 3 Int
  > moved steps = scanl f 0 steps where
  >     f :: Step -> Int -> Int
  >     f = move
  > main :: SF (Event Step) (Event Int)
  > main = proc e -> accumBy (\s n -> move s n) 0 e
  > FROB
  $ frobc check others.frob 2>&1 | grep -e ^error -e hint
  error[E0301]: the parameters of `longer` are in the wrong order
    = hint: write `(\d t -> longer t d)`
  error[E0301]: the parameters of `f` are in the wrong order
    = hint: write `(\y x -> f x y)`
  error[E0301]: the parameters of this function are in the wrong order
     = hint: write `\n s -> …`
  $ frobc fix --all others.frob > /dev/null 2>&1; frobc check others.frob

A function of the program, and one whose parameter does not have variables:

  $ cat > own.frob <<'FROB'
  > import Ros
  > data Step = Up | Down
  > move :: Step -> Int -> Int
  > move s n = if s == Up then n + 1 else n
  > twice :: (b -> a -> b) -> b -> a -> b
  > twice f x y = f (f x y) y
  > once :: (Step -> Int -> Step) -> Step
  > once f = f Up 1
  > main :: SF Step (Int, Step)
  > main = proc s -> (twice move 0 s, once move)
  > FROB
  $ frobc check own.frob
  error[E0301]: the parameters of `move` are in the wrong order
    --> own.frob:10:25
     |
  10 | main = proc s -> (twice move 0 s, once move)
     |                   ----- ^^^^ this is `Step -> Int -> Int`
     |                   |
     |                   the first parameter of the function for `twice` must have the type of its result
     |
     = hint: write `(\n s -> move s n)`
  
  1 error
  [1]
