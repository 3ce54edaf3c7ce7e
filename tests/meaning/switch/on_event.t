`onEvent` runs its body only at the occurrences. The body's dt is the time since its own last
instant, and 0 at its first.

  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ cat > body.frob <<'EOF'
  > main :: SF (Event Float) (Event Float, Event Float, Event Float)
  > main = proc e -> (onEvent (proc _ -> time () / 1[s]) e, onEvent (proc x -> derivative x * 1[s]) e, onEvent (delay 7) e)
  > EOF
  $ printf 'time,in\n0,\n1,2\n2.5,3\n3,4\n4,\n5,5\n6,1\n' > body.csv
  $ both body.frob body.csv
  time,out.1,out.2,out.3
  0.000000000,,,
  1.000000000,0,0,7
  2.500000000,1.5,0.66666666666666663,2
  3.000000000,2,2,3
  4.000000000,,,
  5.000000000,4,0.5,4
  6.000000000,5,-4,5

The body may switch.

  $ cat > modes.frob <<'EOF'
  > main :: SF (Event Float) (Event Float)
  > main = onEvent (switch (proc x -> (x, edge (x > 3))) (\_ -> proc x -> 100 * x + time () / 1[s]))
  > EOF
  $ printf 'time,in\n0,\n1,2\n2.5,3\n3,4\n4,\n5,5\n6,1\n' > modes.csv
  $ both modes.frob modes.csv
  time,out
  0.000000000,
  1.000000000,2
  2.500000000,3
  3.000000000,400
  4.000000000,
  5.000000000,502
  6.000000000,103

`sampleEvery` runs at its first instant and then at its own rate.

  $ cat > rate.frob <<'EOF'
  > main :: SF Float (Event Float)
  > main = sampleEvery 2.5[s] (proc x -> x + time () / 10[s])
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > rate.csv
  $ both rate.frob rate.csv
  time,out
  0.000000000,1
  1.000000000,
  2.000000000,
  3.000000000,4.2999999999999998
  4.000000000,
  5.000000000,5.5
  6.000000000,
  7.000000000,
  8.000000000,1.8
  9.000000000,
  10.000000000,7
