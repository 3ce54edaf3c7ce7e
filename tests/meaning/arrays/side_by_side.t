Signal functions in an array run side by side: on the same input with `parB`, each on its own
element with `parZ`, and on other inputs with a lambda. Both engines agree.

  $ cat > all.frob <<'FROB'
  > sfs :: Array 3 (SF Float Float)
  > sfs = [delay 0, identity, arr (+ 1)]
  > 
  > main :: SF Float (Array 3 Float, Array 3 Float, Array 3 Float, Array 3 Float, Float, Float)
  > main = proc x -> (parB sfs x, map (\f -> f x) sfs, parZ sfs xs, zipWith (\f y -> f y) sfs xs, total, first) where
  >     xs    = [x, 2 * x, delay 0 x]
  >     total = foldl (+) 0 (parB (map lag [1, 2, 3]) (x + 1))
  >     lag k = proc z -> k * delay 1 z
  >     [first, _] = parB [delay 0, integral >>> arr (\y -> y / 1[s])] (x + first)
  > FROB
  $ printf 'time,in\n0,1\n1,2\n2,4\n' > one.csv
  $ frobc trace --lint all.frob --input one.csv | tee c.csv
  time,out.1[0],out.1[1],out.1[2],out.2[0],out.2[1],out.2[2],out.3[0],out.3[1],out.3[2],out.4[0],out.4[1],out.4[2],out.5,out.6
  0.000000000,0,1,2,0,1,2,0,2,1,0,2,1,6,0
  1.000000000,1,2,3,1,2,3,1,4,2,1,4,2,12,1
  2.000000000,2,4,5,2,4,5,2,8,3,2,8,3,18,3
  $ frobc trace all.frob --input one.csv --engine interp | cmp - c.csv

A lambda does not run its variable inside a larger expression:

  $ cat > twice.frob <<'FROB'
  > main :: SF Float (Array 2 Float)
  > main = proc x -> map (\f -> 2 * f x) [delay 0, identity]
  > FROB
  $ frobc check twice.frob
  error[E0343]: `f` is run in a function
   --> twice.frob:2:33
    |
  2 | main = proc x -> map (\f -> 2 * f x) [delay 0, identity]
    |                        -        ^^^ `f` has a value only here
    |                        |
    |                        `f` is bound here
    |
    = hint: use `parB` to run an array of signal functions on one input, or `parZ` to run each on its own input
  
  1 error
  [1]
