If a loop runs over an array of equal elements, there is no array in C: each iteration uses the same
value.

  $ cat > gains.frob <<'END'
  > data In = In { gain :: Float, xs :: Array 4 Float }
  > 
  > main :: SF In (Array 4 Float)
  > main = proc i -> mapSF weighed (zipWith (,) (fill i.gain) i.xs)
  > 
  > fill :: a -> Array n a
  > fill x = generate (\_ -> x)
  > 
  > weighed :: SF (Float, Float) Float
  > weighed = proc (gain, x) -> integral (gain * x / 1[s])
  > END
  $ frobc compile gains.frob --lint
  $ grep -c 'fill' gains.c
  0
  [1]
  $ printf 'time,in.gain,in.xs[0],in.xs[1],in.xs[2],in.xs[3]\n0,2,1,2,3,4\n1,3,1,2,3,4\n2,0,1,1,1,1\n' > in.csv
  $ frobc trace gains.frob --input in.csv > c.csv
  $ frobc trace gains.frob --input in.csv --engine interp | cmp - c.csv
  $ cat c.csv
  time,out[0],out[1],out[2],out[3]
  0.000000000,0,0,0,0
  1.000000000,2,4,6,8
  2.000000000,5,10,15,20
