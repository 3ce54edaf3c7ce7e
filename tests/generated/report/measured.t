The report's statements are true for the C code: the state has exactly this size, the program calls
exactly these functions of the C library and the runtime, and no function uses more stack, with and
without optimization. For the examples, except those with state in the user's C,

  $ sh measure.sh $(grep -L '^foreign sf' $(grep -l '^main' ../../../examples/*/*.frob))
  all measured

for the programs of other tests,

  $ sh measure.sh $(grep -l '^main' ../../meaning/interp/*.frob ../../meaning/paper/*.frob ../../meaning/signal_functions/*.frob)
  all measured

for modes with parameters, for signal functions with instants of their own, and
for nested modes,

  $ cat > modes.frob <<EOF
  > data Side = LeftSide Float | RightSide Float
  > 
  > main :: SF (Float, Event Float) (Float, Float, Float)
  > main = proc (x, e) -> (near (x, e), watch (x, e), looped x)
  > 
  > near :: SF (Float, Event Float) Float
  > near = switch (proc (x, e) -> (hypot x 1, mapE LeftSide e)) (\\s -> far s 2)
  > 
  > far :: Side -> Float -> SF (Float, Event Float) Float
  > far side k = dSwitch (proc (x, e) -> (inner (x, e) + along side k, edge (x < 4))) (\\_ -> near)
  > 
  > along :: Side -> Float -> Float
  > along side k = case side of
  >   LeftSide x -> sin x * k
  >   RightSide x -> atan2 x k
  > 
  > inner :: SF (Float, Event Float) Float
  > inner = proc (x, e) -> rSwitch (delay 0) (x, mapE (\\k -> proc y -> k * delay k y) e)
  > 
  > watch :: SF (Float, Event Float) Float
  > watch = proc (x, e) -> hold 0 (onEvent (proc y -> integral y / 1[s]) e)
  > 
  > -- Its output feeds back to an input that it does not need.
  > looped :: SF Float Float
  > looped = proc x -> y where
  >   y = slow (x - y)
  > 
  > slow :: SF Float Float
  > slow = dSwitch (proc x -> (delay 0 (sin x), edge (x > 5))) (\\_ -> delay 1 >>> delay 2)
  > EOF
  $ sh measure.sh modes.frob
  all measured

for values that are passed to C and back, whether or not the program uses them,

  $ cat > crossing.frob <<EOF
  > data Side = LeftSide | RightSide
  > data Spot = Nowhere | Spot { near :: Distance, around :: Array 2 Float, side :: Side }
  > 
  > foreign scaled :: Array 30 Float -> Float -> (Array 30 Float, Float) = "scaled"
  > foreign wide :: (Array 2 (Array 3 Float), Maybe Float) -> (Float, Array 1000 (Maybe Float)) = "wide"
  > foreign moved :: Spot -> Array 2 Float -> Spot = "moved"
  > 
  > main :: SF (Distance, Array 30 Float) (Float, Float, Spot)
  > main = proc (d, xs) -> (snd (scaled xs x), fst (wide ([[x, 2, 3], [1, 2, x]], Just x)), spot) where
  >     x = d / 1[m]
  >     spot = moved (Spot { near = d, around = [x, 0.1], side = LeftSide }) [x, xs ! 2]
  > EOF
  $ sh measure.sh crossing.frob
  all measured

in single precision,

  $ REAL=float sh measure.sh crossing.frob $(grep -l '^main' ../../meaning/interp/*.frob) modes.frob ../../../examples/wall_follow/wall_follow.frob
  all measured

and for random programs.

  $ for seed in 1 2 3 4; do ./random_programs.exe $seed 10 > random_$seed.frob; done
  $ sh measure.sh random_*.frob
  all measured
  $ REAL=float sh measure.sh random_*.frob
  all measured
