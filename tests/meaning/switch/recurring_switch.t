With `rSwitch`, each event carries the signal function that runs from this
instant on; with `drSwitch`, from the next instant on.

  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ cat > bring.frob <<'EOF'
  > main :: SF Float (Float, Float)
  > main = proc x -> (rSwitch (constant 0) (x, e x), drSwitch (constant 0) (x, e x))
  > 
  > e :: SF Float (Event (SF Float Float))
  > e = proc x -> tag (edge (x > 2)) (proc y -> y + 1000 + time () / 1[s])
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > bring.csv
  $ both bring.frob bring.csv
  time,out.1,out.2
  0.000000000,0,0
  1.000000000,0,0
  2.000000000,1003,0
  3.000000000,1005,1005
  4.000000000,1003,1003
  5.000000000,1005,1008
  6.000000000,1002,1002
  7.000000000,1003,1005
  8.000000000,1002,1002
  9.000000000,1003,1005
  10.000000000,1007,1007

The signal function in the event may use signals: it captures them as they are
at that instant, also as the initial value of a `delay`.

  $ cat > capture.frob <<'EOF'
  > main :: SF Float (Float, Float)
  > main = proc x -> (rSwitch (constant 0) (x, tag (edge (x > 2)) (proc y -> y + z)), rSwitch (constant 0) (x, tag (edge (x > 2)) (delay z))) where
  >     z = 100 * x
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > capture.csv
  $ both capture.frob capture.csv
  time,out.1,out.2
  0.000000000,0,0
  1.000000000,0,0
  2.000000000,303,300
  3.000000000,304,3
  4.000000000,301,4
  5.000000000,505,500
  6.000000000,501,5
  7.000000000,303,300
  8.000000000,301,3
  9.000000000,303,300
  10.000000000,306,3

The event carries one of several.

  $ cat > several.frob <<'EOF'
  > main :: SF Float Float
  > main = proc x -> rSwitch identity (x, mergeE (tag (edge (x > 3)) (arr (\y -> 10 * y))) (tag (edge (x > 2)) (proc y -> y + x)))
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > several.csv
  $ both several.frob several.csv
  time,out
  0.000000000,1
  1.000000000,2
  2.000000000,6
  3.000000000,40
  4.000000000,10
  5.000000000,50
  6.000000000,10
  7.000000000,6
  8.000000000,4
  9.000000000,6
  10.000000000,60

The running signal function may itself be a switch, which the control or its own
event ends; if the old one switches at the instant of a `drSwitch`, its output
is seen once more.

  $ cat > both.frob <<'EOF'
  > main :: SF Float (Float, Float)
  > main = proc x -> (rSwitch ends (x, e), drSwitch ends (x, e)) where
  >     ends = switch (proc y -> (y, edge (y > 2))) (\_ -> arr (\y -> 10 * y))
  >     e = tag (edge (x > 3)) (proc y -> y + 100)
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > both.csv
  $ both both.frob both.csv
  time,out.1,out.2
  0.000000000,1,1
  1.000000000,2,2
  2.000000000,30,30
  3.000000000,104,40
  4.000000000,101,101
  5.000000000,105,105
  6.000000000,101,101
  7.000000000,103,103
  8.000000000,101,101
  9.000000000,103,103
  10.000000000,106,106
