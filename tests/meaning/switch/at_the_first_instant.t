An occurrence at the first instant counts: the output of the mode that ends is never seen.

  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ cat > first.frob <<'EOF'
  > main :: SF Float Float
  > main = switch (proc x -> (x, now 5 ())) (\w -> proc _ -> w + time () / 1[s])
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n' > first.csv
  $ both first.frob first.csv
  time,out
  0.000000000,5
  1.000000000,6
  2.000000000,7
  3.000000000,8
  4.000000000,9
  5.000000000,10

Several switches within one instant take no time: each sees the same input, and
dt 0.

  $ cat > chain.frob <<'EOF'
  > main :: SF Float Float
  > main = switch (proc x -> (x, tag (edge (x > 2)) x))
  >     (\a -> switch (proc x -> (x, tag (now () ()) (a + x)))
  >         (\b -> switch (proc x -> (x, tag (now () ()) (a + b + x)))
  >             (\c -> proc x -> 1000 * a + 100 * b + 10 * c + time () / 1[s] + integral x / 1[s])))
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n' > chain.csv
  $ both chain.frob chain.csv
  time,out
  0.000000000,1
  1.000000000,2
  2.000000000,3720
  3.000000000,3724
  4.000000000,3729
  5.000000000,3731
