If a condition on a parameter chooses a signal function, the choice is made when
it starts, also when a switch starts it; the other one does not run.

  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ cat > chosen.frob <<'EOF'
  > one :: Float -> SF Float Float
  > one p = if p > 2.5 then integral >>> arr (\a -> a / 1[s]) else delay p
  > 
  > main :: SF Float (Float, Float, Float)
  > main = proc x -> (one 1 x, one (sqrt 9) x, switch (proc y -> (y, tag (edge (y > 2)) y)) (\w -> one (w - 1)) x)
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > chosen.csv
  $ both chosen.frob chosen.csv
  time,out.1,out.2,out.3
  0.000000000,1,0,1
  1.000000000,1,1,2
  2.000000000,2,3,2
  3.000000000,3,6,3
  4.000000000,4,10,4
  5.000000000,1,11,1
  6.000000000,5,16,5
  7.000000000,1,17,1
  8.000000000,3,20,3
  9.000000000,1,21,1
  10.000000000,3,24,3
