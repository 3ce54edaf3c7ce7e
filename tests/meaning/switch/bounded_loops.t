A cycle of modes that ends within the instant is not an error. The compiler derives how far it goes
from the known ranges of the numbers that modes pass on, and of the input, which is the same for all
of them. The report states the number of steps.

  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cut -d, -f2- c.csv | xargs && frobc report "$1" | sed -n 's/.*; \(maximum number of steps.*\)$/\1/p'; }
  $ printf 'time,in\n0,0\n1,2\n2,-1\n3,4\n4,0\n5,1\n6,-2\n7,3\n' > in.csv

Counters, up to a number and to exactly that number.

  $ cat > counter.frob <<'EOF'
  > step :: Task Float Float ()
  > step = mkTask (proc x -> (x, when (x > 1)))
  > 
  > go :: Int -> Task Float Float Int
  > go n = do
  >     step
  >     if n >= 3 then return n else go (n + 1)
  > 
  > main :: SF Float (Either Float Int)
  > main = runTask (go 0)
  > EOF
  $ both counter.frob in.csv
  out Left 0 Right 3 Right 3 Right 3 Right 3 Right 3 Right 3 Right 3
  maximum number of steps within one instant: 5
  $ cat > equal.frob <<'EOF'
  > step :: Task Float Float ()
  > step = mkTask (proc x -> (x, when (x > 1)))
  > 
  > go :: Int -> Task Float Float Int
  > go n = do
  >     step
  >     if n == 100 then return n else go (n + 1)
  > 
  > main :: SF Float (Either Float Int)
  > main = runTask (go 0)
  > EOF
  $ both equal.frob in.csv
  out Left 0 Right 100 Right 100 Right 100 Right 100 Right 100 Right 100 Right 100
  maximum number of steps within one instant: 102
  $ cat > without_time.frob <<'EOF'
  > go :: Int -> Task Float Float Int
  > go n = if n >= 3 then return n else do
  >     x <- snapT
  >     if x > 1 then sleepT 1[s] 2 else return ()
  >     go (n + 1)
  > 
  > main :: SF Float (Either Float Int)
  > main = runTask (go 0)
  > EOF
  $ both without_time.frob in.csv
  out Right 3 Right 3 Right 3 Right 3 Right 3 Right 3 Right 3 Right 3
  maximum number of steps within one instant: 4
  $ cat > modes.frob <<'EOF'
  > main :: SF Float Float
  > main = go 0 where
  >     go n = switch (proc x -> (x + toFloat n, gate (when (x > 1)) (n < 5))) (\_ -> go (n + 1))
  > EOF
  $ both modes.frob in.csv
  out 0 7 4 9 5 6 3 8
  maximum number of steps within one instant: 6

A number that passes through a signal function keeps its known range.

  $ cat > through.frob <<'EOF'
  > step :: Task Float Float ()
  > step = mkTask (proc x -> (x, when (x > 1)))
  > 
  > go :: Int -> Int -> Task Float Float Int
  > go most n = do
  >     step
  >     if n >= most then return n else go most (n + 1)
  > 
  > counted :: Int -> SF Float (Either Float Int)
  > counted n = proc x -> runTask (go n 0) (x + 1)
  > 
  > main :: SF Float (Either Float Int)
  > main = proc x -> counted 3 (x * 2)
  > EOF
  $ both through.frob in.csv
  out Left 1 Right 3 Right 3 Right 3 Right 3 Right 3 Right 3 Right 3
  maximum number of steps within one instant: 5

Repetitions of the library, with a constant number and with a bounded one.

  $ cat > repeat.frob <<'EOF'
  > step :: Task Float Float ()
  > step = mkTask (proc x -> (x, when (x > 1)))
  > 
  > main :: SF Float (Either Float ())
  > main = runTask (repeatT 4 step)
  > EOF
  $ both repeat.frob in.csv
  out Left 0 Right () Right () Right () Right () Right () Right () Right ()
  maximum number of steps within one instant: 5
  $ cat > limited.frob <<'EOF'
  > step :: Task Float Float ()
  > step = mkTask (proc x -> (x, when (x > 1)))
  > 
  > main :: SF Float (Either Float ())
  > main = initially (\x -> runTask (repeatT (min 10 (round x + 2)) step))
  > EOF
  $ both limited.frob in.csv
  out Left 0 Right () Right () Right () Right () Right () Right () Right ()
  maximum number of steps within one instant: 12
  $ cat > for_each.frob <<'EOF'
  > visit :: Float -> Task Float Float ()
  > visit p = mkTask (proc x -> (x, when (x > p)))
  > 
  > main :: SF Float (Either Float ())
  > main = runTask (forever (do
  >     forEachT [1, 2, 3] visit
  >     sleepT 1[s] 0))
  > EOF
  $ both for_each.frob in.csv
  out Left 0 Left 2 Left (-1) Left 0 Left 0 Left 1 Left (-2) Left 3
  maximum number of steps within one instant: 5

The maximum is a thousand steps.

  $ sed 's/repeatT 4/repeatT 1000/' repeat.frob > many.frob
  $ frobc report many.frob | grep -o 'maximum number of steps.*'
  maximum number of steps within one instant: 1001
  $ sed 's/repeatT 4/repeatT 1001/' repeat.frob > too_many.frob
  $ frobc check too_many.frob 2>&1 | grep -e E0402 -e 'finding an end'
  error[E0402]: `step → repeatT → step` may repeat endlessly within one instant
      = note: frobc stopped after 1000 steps, the maximum for one instant, without finding an end

The condition that ended one mode keeps the next one running.

  $ cat > hysteresis.frob <<'EOF'
  > high, low :: SF Float Float
  > high = switch (proc x -> (1, when (x < 0))) (\_ -> low)
  > low = switch (proc x -> (0, when (x > 1))) (\_ -> high)
  > 
  > main = low
  > EOF
  $ both hysteresis.frob in.csv
  out 0 1 0 1 1 1 0 1
  maximum number of steps within one instant: 2

A task that measures the distance from the robot's own position starts with a distance of 0.

  $ cat > square.frob <<'EOF'
  > import Geometry
  > 
  > side :: Task Pose Velocity ()
  > side = do
  >     i <- snapT
  >     mkTask (proc j -> (1[m/s], when (distance j.position i.position >= 1[m])))
  > 
  > turn :: Task Pose Velocity ()
  > turn = do
  >     i <- snapT
  >     mkTask (proc j -> (0, when (abs (angleDiff j.heading i.heading) >= 90[deg])))
  > 
  > square :: Int -> Task Pose Velocity ()
  > square n = do
  >     side
  >     turn
  >     if n == 4 then return () else square (n + 1)
  > 
  > main :: SF Float (Either Velocity ())
  > main = proc x -> runTask (forever (square 1)) (pose x)
  > pose :: Float -> Pose
  > pose x = Pose { position = Vec2 (x * 1[m]) 0, heading = x * 1[rad] }
  > EOF
  $ both square.frob in.csv
  out Left 1 Left 0 Left 1 Left 0 Left 1 Left 0 Left 1 Left 0
  maximum number of steps within one instant: 2

The initial values of a repetition are also known if an event carries it, and if its cycle is in a
mode that never starts.

  $ cat > brought.frob <<'EOF'
  > main :: SF (Int, Bool) Int
  > main = proc (x, b) -> rSwitch identity (x, mapE (\() -> go 0) (when b))
  > 
  > go :: Int -> SF Int Int
  > go n = switch (identity &&& now ()) (\_ -> if n >= 2 then arr (\x -> x + n) else go (n + 1))
  > EOF
  $ printf 'time,in.1,in.2\n0,1,false\n1,2,true\n2,5,false\n' > brought.csv
  $ frobc trace brought.frob --input brought.csv
  time,out
  0.000000000,1
  1.000000000,4
  2.000000000,7
  $ cat > never_started.frob <<'EOF'
  > main :: SF Int Int
  > main = switch (proc x -> (x, tag (edge (x > 0)) 0)) (\_ -> switch (identity &&& (proc _ -> when (1 > 2))) (\_ -> go 0))
  > 
  > go :: Int -> SF Int Int
  > go n = switch (identity &&& now ()) (\_ -> if n == 2 then arr (\x -> x + n) else go (n + 1))
  > EOF
  $ frobc check never_started.frob

The same if the tested value implies that the mode never starts.

  $ cat > never_asked.frob <<'EOF'
  > main :: SF Float (Int, Int)
  > main = first 0 where
  >     first n = switch (constant (n, 1) &&& (proc x -> when (x > 3)))
  >                      (\_ -> if n >= 0 then constant (7, n) else second (n + 1))
  >     second n = dSwitch (let go k = switch (constant ((n, k), Event ()) &&& (proc _ -> when True))
  >                                           (\_ -> if k >= 1 then constant ((n, 5), NoEvent) else go (k + 1))
  >                         in go 1)
  >                        (\_ -> if n >= 1 then constant (n, 9) else first (n + 1))
  > EOF
  $ frobc check never_asked.frob
