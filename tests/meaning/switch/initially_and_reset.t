`initially` chooses by the input at the first instant.

  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ cat > first.frob <<'EOF'
  > main :: SF Float (Float, Float)
  > main = proc x -> (initially (\x0 -> arr (\y -> y - x0)) x, initially (\x0 -> if x0 > 0.5 then delay x0 else identity) x)
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > first.csv
  $ both first.frob first.csv
  time,out.1,out.2
  0.000000000,0,1
  1.000000000,1,1
  2.000000000,2,2
  3.000000000,3,3
  4.000000000,0,4
  5.000000000,4,1
  6.000000000,0,5
  7.000000000,2,1
  8.000000000,0,3
  9.000000000,2,1
  10.000000000,5,3

`resetOn` restarts at each occurrence.

  $ cat > reset.frob <<'EOF'
  > main :: SF Float (Float, Float)
  > main = proc x -> (resetOn time (x, e) / 1[s], resetOn (delay 7) (x, e)) where
  >     e = edge (x > 2)
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > reset.csv
  $ both reset.frob reset.csv
  time,out.1,out.2
  0.000000000,0,7
  1.000000000,1,1
  2.000000000,0,7
  3.000000000,1,3
  4.000000000,2,4
  5.000000000,0,7
  6.000000000,1,5
  7.000000000,0,7
  8.000000000,1,3
  9.000000000,0,7
  10.000000000,1,3
