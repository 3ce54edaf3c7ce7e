A switch inside a mode has its own state, and starts with the mode.

  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ cat > inside.frob <<'EOF'
  > inner :: SF Float Float
  > inner = switch (proc x -> (x, edge (x > 2))) (\_ -> proc _ -> 40 + time () / 1[s])
  > 
  > outer :: SF Float (Float, Float)
  > outer = switch (proc x -> ((inner x, inner (x - 1)), edge (x > 4))) (\_ -> outer)
  > 
  > main = outer
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > inside.csv
  $ both inside.frob inside.csv
  time,out.1,out.2
  0.000000000,1,0
  1.000000000,2,1
  2.000000000,40,2
  3.000000000,41,40
  4.000000000,42,41
  5.000000000,5,4
  6.000000000,1,0
  7.000000000,40,2
  8.000000000,41,0
  9.000000000,42,2
  10.000000000,6,5

A switch may output the event of another switch.

  $ cat > events.frob <<'EOF'
  > main :: SF Float Float
  > main = switch (switch (proc x -> ((x, NoEvent), edge (x > 2))) (\_ -> proc x -> ((10 * x, tag (edge (x > 3)) x)))) (\w -> constant w)
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > events.csv
  $ both events.frob events.csv
  time,out
  0.000000000,1
  1.000000000,2
  2.000000000,30
  3.000000000,4
  4.000000000,4
  5.000000000,4
  6.000000000,4
  7.000000000,4
  8.000000000,4
  9.000000000,4
  10.000000000,4
