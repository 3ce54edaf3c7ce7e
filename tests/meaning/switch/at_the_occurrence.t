At the instant of the event, the output of the first signal function is dropped; its successor runs
on the same input, at its local time 0, and receives the event's value.

  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ cat > ends.frob <<'EOF'
  > main :: SF Float Float
  > main = switch (proc x -> (x, tag (edge (x > 2)) (10 * x))) (\w -> proc x -> w + x + time () / 1[s])
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n' > ends.csv
  $ both ends.frob ends.csv
  time,out
  0.000000000,1
  1.000000000,2
  2.000000000,33
  3.000000000,35
  4.000000000,33
  5.000000000,38

An event after the first one has no effect.

  $ cat > once.frob <<'EOF'
  > main :: SF Float (Float, Int)
  > main = switch (proc x -> ((x, 1), edge (x > 2))) (\_ -> proc _ -> (100, 2))
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n' > once.csv
  $ both once.frob once.csv
  time,out.1,out.2
  0.000000000,1,1
  1.000000000,2,1
  2.000000000,100,2
  3.000000000,100,2
  4.000000000,100,2
  5.000000000,100,2
