`0 - abs x` is 0 for x = 0, not -0, whatever the C compiler folds.

  $ cat > zero.frob <<'FROB'
  > main :: SF Float (Float, Float, Float)
  > main = proc x -> (0 - abs x, 0 + (- abs x), (- abs x) + 0)
  > FROB
  $ printf 'time,in\n0,0\n1,-0.0\n2,3\n' > zero.csv
  $ CC=gcc frobc trace zero.frob --input zero.csv
  time,out.1,out.2,out.3
  0.000000000,0,0,0
  1.000000000,0,0,0
  2.000000000,-3,-3,-3
  $ CC=clang frobc trace zero.frob --input zero.csv | cksum > clang
  $ frobc trace zero.frob --input zero.csv --engine interp | cksum | cmp - clang
