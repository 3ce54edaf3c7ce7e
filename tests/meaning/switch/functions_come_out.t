A switch may output functions that are computed from signals: control sources
are composed in this way.

  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ cat > sources.frob <<'EOF'
  > source :: SF Float (Float -> Float)
  > source = switch (proc x -> ((\y -> 2 * y), edge (x > 2))) (\_ -> proc x -> if x > 3 then (\y -> y + x) else (\y -> y - 100))
  > 
  > main :: SF Float Float
  > main = proc x -> f x where
  >     f = source x
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > sources.csv
  $ both sources.frob sources.csv
  time,out
  0.000000000,2
  1.000000000,4
  2.000000000,-97
  3.000000000,8
  4.000000000,-99
  5.000000000,10
  6.000000000,-99
  7.000000000,-97
  8.000000000,-99
  9.000000000,-97
  10.000000000,12
