Signal functions that start each other in tail position are the modes of one
machine; their parameters are stored.

  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ cat > bounce.frob <<'EOF'
  > up, down :: Float -> SF Float Float
  > up n = switch (proc x -> (n, edge (x > 2))) (\_ -> down (n + 1))
  > down n = dSwitch (proc x -> (-n, edge (x > 3))) (\_ -> up (n * 2))
  > 
  > main = up 1
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > bounce.csv
  $ both bounce.frob bounce.csv
  time,out
  0.000000000,1
  1.000000000,1
  2.000000000,-2
  3.000000000,-2
  4.000000000,4
  5.000000000,-5
  6.000000000,-5
  7.000000000,-5
  8.000000000,-5
  9.000000000,-5
  10.000000000,-5

All parameters are assigned at once.

  $ cat > swap.frob <<'EOF'
  > go :: Float -> Float -> SF Float (Float, Float)
  > go a b = switch (proc x -> ((a, b), edge (x > 2))) (\_ -> go b (a + b))
  > 
  > main = go 1 2
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > swap.csv
  $ both swap.frob swap.csv
  time,out.1,out.2
  0.000000000,1,2
  1.000000000,1,2
  2.000000000,2,3
  3.000000000,2,3
  4.000000000,2,3
  5.000000000,3,5
  6.000000000,3,5
  7.000000000,5,8
  8.000000000,5,8
  9.000000000,8,13
  10.000000000,8,13

A branch on the event's value is a tail position, and so are the body of a `let`
and `proc x -> sf x`.

  $ cat > branches.frob <<'EOF'
  > start :: Float -> SF Float Float
  > start v = let sf = run v in proc x -> sf x
  > 
  > run :: Float -> SF Float Float
  > run v = switch (proc x -> (v, tag (edge (x > 2)) x)) (\x ->
  >     if x > 5 then constant 1000 else case x > 3.5 of
  >         True -> start (v + 0.5)
  >         False -> let w = v + 10 in run w)
  > 
  > main = run 0
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > branches.csv
  $ both branches.frob branches.csv
  time,out
  0.000000000,0
  1.000000000,0
  2.000000000,10
  3.000000000,10
  4.000000000,10
  5.000000000,10.5
  6.000000000,10.5
  7.000000000,20.5
  8.000000000,20.5
  9.000000000,30.5
  10.000000000,30.5

Parameters may be signal functions, if there are finitely many.

  $ cat > chosen.frob <<'EOF'
  > alternate :: SF Float Float -> SF Float Float -> SF Float Float
  > alternate a b = switch (proc x -> (a x, edge (x > 2))) (\_ -> alternate b a)
  > 
  > main = alternate (arr (\x -> 10 * x)) (integral >>> arr (\y -> y / 1[s]))
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n6,1\n7,3\n8,1\n9,3\n10,6\n' > chosen.csv
  $ both chosen.frob chosen.csv
  time,out
  0.000000000,10
  1.000000000,20
  2.000000000,0
  3.000000000,3
  4.000000000,7
  5.000000000,50
  6.000000000,10
  7.000000000,0
  8.000000000,3
  9.000000000,30
  10.000000000,60
