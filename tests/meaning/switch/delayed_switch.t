With `dSwitch` the output at the occurrence is still that of the old signal
function. The new one takes its first step there, unseen: a second later its
local time is 1.

  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ cat > late.frob <<'EOF'
  > main :: SF Float Float
  > main = dSwitch (proc x -> (x, tag (edge (x > 2)) 100)) (\w -> proc _ -> w + time () / 1[s])
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n' > late.csv
  $ both late.frob late.csv
  time,out
  0.000000000,1
  1.000000000,2
  2.000000000,3
  3.000000000,101
  4.000000000,102
  5.000000000,103

The same at the first instant.

  $ cat > first.frob <<'EOF'
  > main :: SF Float Float
  > main = dSwitch (proc x -> (x, now 100 ())) (\w -> proc x -> w + delay 7 x)
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n' > first.csv
  $ both first.frob first.csv
  time,out
  0.000000000,1
  1.000000000,101
  2.000000000,102
  3.000000000,103
  4.000000000,104
  5.000000000,101

Events of that unseen instant count: the second signal function ends
immediately.

  $ cat > chain.frob <<'EOF'
  > main :: SF Float Float
  > main = dSwitch (proc x -> (x, now 1 ()))
  >     (\a -> switch (proc x -> (x + 1000, now (a + 1) ())) (\b -> proc _ -> 100 * b + time () / 1[s]))
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n' > chain.csv
  $ both chain.frob chain.csv
  time,out
  0.000000000,1
  1.000000000,201
  2.000000000,202
  3.000000000,203
  4.000000000,204
  5.000000000,205

A mode that a delayed transition has started unseen stays unseen until the end
of the instant.

  $ cat > mixed.frob <<'EOF'
  > main :: SF Float Float
  > main = switch (proc x -> (x, edge (x > 2)))
  >     (\_ -> dSwitch (proc x -> (x + 50, now 1 ()))
  >         (\_ -> switch (proc x -> (x + 70, now 2 ())) (\_ -> proc x -> x + 90)))
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n' > mixed.csv
  $ both mixed.frob mixed.csv
  time,out
  0.000000000,1
  1.000000000,2
  2.000000000,53
  3.000000000,94
  4.000000000,91
  5.000000000,95
