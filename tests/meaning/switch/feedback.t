The output of a switch may depend on itself if it is only read with a delay.

  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ cat > position.frob <<'EOF'
  > main :: SF Float Float
  > main = proc target -> x where
  >     x = rSwitch integral (v, tag (edge (target > 4)) (proc u -> 7[s] + delay 0 u * 1[s])) / 1[s]
  >     v = target - x
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > position.csv
  $ both position.frob position.csv
  time,out
  0.000000000,0
  1.000000000,1
  2.000000000,2
  3.000000000,3
  4.000000000,4
  5.000000000,7
  6.000000000,5
  7.000000000,3
  8.000000000,7
  9.000000000,1
  10.000000000,7

With `dSwitch` the event may depend on the output of the same instant.

  $ cat > event.frob <<'EOF'
  > main :: SF Float Float
  > main = proc x -> y where
  >     y = dSwitch (proc u -> (10, edge (u > 12))) (\_ -> delay 0) (y + x)
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > event.csv
  $ both event.frob event.csv
  time,out
  0.000000000,10
  1.000000000,10
  2.000000000,10
  3.000000000,13
  4.000000000,17
  5.000000000,18
  6.000000000,23
  7.000000000,24
  8.000000000,27
  9.000000000,28
  10.000000000,31

With `switch` it may not: the switch is treated as a unit.

  $ cat > loop.frob <<'EOF'
  > main :: SF Float Float
  > main = proc x -> y where
  >     y = switch (proc u -> (10, edge (u > 12))) (\_ -> delay 0) (y + x)
  > EOF
  $ frobc check loop.frob
  error[E0401]: the signal `y` needs its own value in the same instant
   --> loop.frob:3:5
    |
  3 |     y = switch (proc u -> (10, edge (u > 12))) (\_ -> delay 0) (y + x)
    |     ^                                                           ----- `y` reads `y` here, through a switch
    |
    = note: each output of a switch depends on every input that the signal functions inside the switch read in the same instant
    = hint: let `y` read its own previous value: add the equation `before = delay 0 y`, where 0 is the initial value, and read `before` here
  
  1 error
  [1]

Each output of a machine is known as soon as its own inputs are.

  $ cat > parts.frob <<'EOF'
  > step :: SF (Float, Float) (Float, Float)
  > step = dSwitch (proc (u, w) -> ((u, delay 1 w), edge (w > 3))) (\_ -> proc (u, w) -> (2 * u, delay 5 (w + u)))
  > 
  > main :: SF Float (Float, Float)
  > main = proc x -> (a, b) where
  >     (a, b) = step (x, 0.5 * b + a)
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > parts.csv
  $ both parts.frob parts.csv
  time,out.1,out.2
  0.000000000,1,1
  1.000000000,2,1.5
  2.000000000,3,2.75
  3.000000000,8,7.375
  4.000000000,2,15.6875
  5.000000000,10,10.84375
  6.000000000,2,20.421875
  7.000000000,6,13.2109375
  8.000000000,2,15.60546875
  9.000000000,6,10.802734375
  10.000000000,12,14.4013671875
