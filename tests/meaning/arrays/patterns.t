A pattern matches all elements of an array: in the parameters of a function, of a `proc` and of a
lambda, in equations, `let` and `case`. Both engines agree.

  $ cat > apart.frob <<'FROB'
  > pair :: Array 2 a -> (a, a)
  > pair [a, b] = (a, b)
  > 
  > middle :: Array 3 Int -> Int
  > middle xs = case xs of
  >     [0, _, _] -> -1
  >     [a, b, 2] | a > b -> a
  >               | b > a -> b
  >     [_, 5, c] -> c
  >     _ -> 7
  > 
  > rotate :: Array 3 a -> Array 3 a
  > rotate = \[a, b, c] -> [b, c, a]
  > 
  > nested :: Array 2 (Array 2 (Maybe Int)) -> Int
  > nested = \case
  >     [[Just a, _], _all@[_, Just b]] -> a + b
  >     [[Nothing, _], [Nothing, _]] -> 0
  >     [_, [x, y]] -> fromMaybe 1 x - fromMaybe 2 y
  > 
  > main :: SF (Array 3 Int) (Int, Int, Array 3 Int, (Float, Float), Int, Float)
  > main = proc xs@[a, _, c] -> (m, sum3, rotate xs, pair outs, nested [[Just a, Nothing], [if c > 0 then Just c else Nothing, Just 4]], out0) where
  >     m = middle xs
  >     [d, e, f'] = map (\x -> x * 2) xs
  >     sum3 = d + e + f' + (let [p, q] = [a, c] in p * q)
  >     outs = runBoth (toFloat a)
  >     [out0, _] = [f 3.0, g 1.0]
  >     [f, g] = map (\k x -> k * x + toFloat a) [2, 3]
  > 
  > sfs :: Array 2 (SF Float Float)
  > sfs = [delay 0, identity]
  > 
  > runBoth :: SF Float (Array 2 Float)
  > runBoth = proc x -> [p x, q x] where
  >     [p, q] = sfs
  > FROB
  $ cat > apart.csv <<'CSV'
  > time,in[0],in[1],in[2]
  > 0,1,2,3
  > 1,0,2,3
  > 2,4,3,2
  > 3,4,5,9
  > CSV
  $ frobc trace --lint apart.frob --input apart.csv | tee c.csv
  time,out.1,out.2,out.3[0],out.3[1],out.3[2],out.4.1,out.4.2,out.5,out.6
  0.000000000,7,15,2,3,1,0,1,5,7
  1.000000000,-1,10,2,3,0,1,0,4,6
  2.000000000,4,26,3,2,4,0,4,8,10
  3.000000000,9,72,5,9,4,4,4,8,10
  $ frobc trace apart.frob --input apart.csv --engine interp | cmp - c.csv

A `case` on arrays must cover all values, and any other pattern must match every
value:

  $ cat > uncovered.frob <<'FROB'
  > g :: Array 2 Bool -> Int
  > g xs = case xs of
  >     [True, _] -> 1
  >     [False, True] -> 2
  > 
  > l [1, x] = x
  > FROB
  $ frobc check uncovered.frob
  error[E0350]: this `case` does not cover every value
   --> uncovered.frob:2:13
    |
  2 | g xs = case xs of
    |             ^^ there is no branch for `[False, False]`
    |
    = hint: add a branch `[False, False] -> …`
  
  error[E0351]: the pattern of a function must match every value
   --> uncovered.frob:6:3
    |
  6 | l [1, x] = x
    |   ^^^^^^ does not match `[0, _]`
    |
    = hint: use a `case`, with a branch for `[0, _]` too
  
  2 errors
  [1]

A pattern must have as many elements as the array:

  $ cat > size.frob <<'FROB'
  > f :: Array 3 Int -> Int
  > f [a, b] = a + b
  > 
  > k :: Array n Int -> Int
  > k [a, _] = a
  > FROB
  $ frobc check size.frob
  error[E0301]: expected `Array 3 Int`, found `Array 2 Int`
   --> size.frob:2:3
    |
  1 | f :: Array 3 Int -> Int
    |      ------------------ the signature of `f` requires the parameter `Array 3 Int`
  2 | f [a, b] = a + b
    |   ^^^^^^
    |
    = hint: use `take` or `drop` to change the size of an array; the type of the result gives the new size
  
  error[E0306]: the signature allows any size `n`, but the definition needs it to be `2`
   --> size.frob:5:3
    |
  4 | k :: Array n Int -> Int
    |      ------------------ `n` is any size in the signature of `k`
  5 | k [a, _] = a
    |   ^^^^^^
    |
    = hint: if the definition is right, write the signature as `Array 2 Int -> Int`
  
  2 errors
  [1]
