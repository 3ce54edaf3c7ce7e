The functions and signal functions of the prelude, except those for events,
which have their own tests.

  $ . ./trace.sh

Elementary functions agree with awk's:

  $ cat > elementary.frob << FROB
  > main :: SF (Float, Float) (Float, Float, Float, Float, Float, Float)
  > main = proc (x, y) -> (sin x, cos x, exp x, log (abs x), sqrt (abs x), atan2 y x)
  > FROB
  $ printf '%s\n' 1,2 -3,0.5 0.25,-7 40,0 -2,0 1e-3,1e3 > pairs
  $ rows in.1,in.2 < pairs | trace elementary | cells | rounded > found
  $ awk -F, 'function abs(x) { return x < 0 ? -x : x } { printf "%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n",
  >   sin($1), cos($1), exp($1), log(abs($1)), sqrt(abs($1)), atan2($2, $1) }' pairs | diff - found

The other functions, compared with their definitions:

  $ cat > inverses.frob << FROB
  > main :: SF Float (Float, Float, Float, Float, Float, Float)
  > main = proc x -> (asin (sin x), acos (cos x), atan (tan x), hypot (3 * x) (4 * x), pi, x ** 2)
  > FROB
  $ printf '%s\n' 0.5 1.5 | rows in | trace inverses | cells | rounded
  0.5,0.5,0.5,2.5,3.14159265,0.25
  1.5,1.5,1.5,7.5,3.14159265,2.25

Inverse functions at the ends of their domains:

  $ cat > domains.frob << FROB
  > main :: SF Float (Float, Float, Float)
  > main = proc x -> (asin x, acos x, toFloat (round (atan x * 1e6)))
  > FROB
  $ printf '%s\n' 1 -1 1.5 inf | rows in | trace domains | cells | rounded
  NaN: out.1, first at 2.000 s; to find its origin, run `frobc view --why-nan`
  NaN: out.2, first at 2.000 s
  1.57079633,0,785398
  -1.57079633,3.14159265,-785398
  nan,nan,982794
  nan,nan,1570796

Bools: all combinations.

  $ cat > truth.frob << FROB
  > main :: SF (Bool, Bool) (Bool, Bool, Bool, Bool)
  > main = proc (a, b) -> (a && b, a || b, not a, if a && otherwise then b else a)
  > FROB
  $ printf '%s\n' false,false false,true true,false true,true | rows in.1,in.2 | trace truth | cells
  false,false,true,false
  false,true,true,false
  false,true,false,false
  true,true,false,true

Functions on functions, pairs, Maybe and Either:

  $ cat > functions.frob << FROB
  > minus :: Int -> Int -> Int
  > minus a b = a - b
  > 
  > main :: SF (Int, Maybe Int, Either Int Bool) ((Int, Int, Int, Int), (Int, Int, Int, Int), Int, Int, Int)
  > main = proc (n, m, e) ->
  >     ( (id n, const n m, flip minus n 1, ((* 2) . (+ 3)) n)
  >     , (curry fst n 7, curry snd n 7, uncurry minus (n, 1), (minus \$ n + 1) 1)
  >     , maybe 0 (+ 1) m, fromMaybe 9 m, either (* 10) (\\b -> if b then 1 else 0) e )
  > FROB
  $ printf '%s\n' '5,Just 3,Left 4' '6,Nothing,Right true' | rows in.1,in.2,in.3 | trace functions | cells
  5,5,-4,16,5,7,4,5,4,3,40
  6,6,-5,18,6,7,5,6,0,9,1

Signal functions that have state or depend on time, at uneven steps and one of
length 0. The integral uses the value at the beginning of each step; the
derivative keeps its last value in a step of length 0.

  $ cat > signals.frob << FROB
  > main :: SF Float (Float, Time, Float[s], Float[1/s])
  > main = proc x -> (delay 9 x, time (), integral x, derivative x)
  > FROB
  $ cat > uneven.csv << ROWS
  > time,in
  > 10,1
  > 10.5,3
  > 10.5,4
  > 12.5,0
  > 12.75,-1
  > ROWS
  $ trace signals < uneven.csv | cells
  9,0,0,0
  1,0.5,0.5,4
  3,0.5,0.5,4
  4,2.5,8.5,-2
  0,2.75,8.5,-4

Combinators; the last two are `delay 1 >>> (+ 1)` and a counter.

  $ cat > combinators.frob << FROB
  > twice :: SF Int Int
  > twice = arr (* 2)
  > 
  > main :: SF (Int, Int) ((Int, Int), (Int, Int), (Int, Int), (Int, Int), (Int, Int, Int, Int))
  > main = proc (a, b) ->
  >     ( first twice (a, b), second twice (a, b), (twice *** identity) (a, b), (twice &&& returnA) a
  >     , ((delay 1 >>> arr (+ 1)) a, (arr (+ 1) <<< delay 1) a, constant 7 b, loop counter a) )
  >   where
  >     counter :: SF (Int, Int) (Int, Int)
  >     counter = proc (k, n) -> (n', n') where
  >         n' = k + delay 0 n
  > FROB
  $ printf '%s\n' 1,10 2,20 3,30 | rows in.1,in.2 | trace combinators | cells
  2,10,1,20,2,10,2,1,2,2,7,1
  4,20,2,40,4,20,4,2,2,2,7,3
  6,30,3,60,6,30,6,3,3,3,7,6

Sums and means, also of Ints; the first and the last elements, also more of them than there are:

  $ cat > arrays.frob << FROB
  > main :: SF (Float, Int) (Float, Float, Int, Array 2 Int, Array 4 Int, Array 2 Int, Array 4 Int, Array 3 Int)
  > main = proc (x, n) -> (sum xs, mean xs, sum ns, take ns, take ns, drop ns, drop ns, drop ns) where
  >     xs = [x, 2, 0.5]
  >     ns = [n, 2, 3]
  > FROB
  $ printf '%s\n' 0.5,1 inf,2147483647 nan,-6 | rows in.1,in.2 | trace arrays | cells
  3,1,6,1,2,1,2,3,3,2,3,1,1,2,3,1,2,3
  inf,inf,-2147483644,2147483647,2,2147483647,2,3,3,2,3,2147483647,2147483647,2,3,2147483647,2,3
  nan,nan,-1,-6,2,-6,2,3,3,2,3,-6,-6,2,3,-6,2,3
