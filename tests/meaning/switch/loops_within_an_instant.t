A cycle of switches that may all happen at first instants is rejected; the
message shows what makes each step possible.

  $ cat > ever.frob <<'EOF'
  > go :: Float -> SF Float Float
  > go v = switch (proc x -> (x + v, tag (when (x > -2)) x)) (\w -> rest w)
  > 
  > rest :: Float -> SF Float Float
  > rest v = switch (proc x -> (x + v, after (max 0 (v * 1[s])) ())) (\_ -> go v)
  > 
  > main = go 0.5
  > EOF
  $ frobc check ever.frob
  error[E0402]: `rest → go → rest` may repeat endlessly within one instant
   --> ever.frob:5:18
    |
  2 | go v = switch (proc x -> (x + v, tag (when (x > -2)) x)) (\w -> rest w)
    |                                       -------------             ------ `go` may start `rest` at its own first instant
    |                                       |
    |                                       `when` may occur at the first instant of `go`
  ...
  5 | rest v = switch (proc x -> (x + v, after (max 0 (v * 1[s])) ())) (\_ -> go v)
    |                  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^         ---- `rest` may start `go` at its own first instant
    |                                    |
    |                                    `after` may occur at the first instant of `rest`
    |
    = note: no time passes between these steps when each ends as soon as it starts
    = hint: make the wait at least 1 ns long, for example with `after (max 1[ms] q)`
  
  1 error
  [1]

If time is known to pass in the cycle, here at least 1 ms, the program is
accepted.

  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ cat > waits.frob <<'EOF'
  > go :: Float -> SF Float Float
  > go v = switch (proc x -> (x + v, tag (when (x > 2)) x)) (\w -> rest w)
  > 
  > rest :: Float -> SF Float Float
  > rest v = switch (proc x -> (x + v, after (max 1[ms] (v * 1[s])) ())) (\_ -> go v)
  > 
  > main = go 0.5
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n' > waits.csv
  $ both waits.frob waits.csv
  time,out
  0.000000000,1.5
  1.000000000,2.5
  2.000000000,6
  3.000000000,7
  4.000000000,4
  5.000000000,10

The compiler does not recognize events by their names: these events cannot occur at the first
instant either.

  $ cat > own.frob <<'EOF'
  > later :: SF (Event a) (Event a)
  > later = proc e -> if delay False True then e else NoEvent
  > 
  > main :: SF Float Float
  > main = switch (proc x -> (x, later (when (x > 2)))) (\_ -> main)
  > EOF
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,1\n5,5\n' > own.csv
  $ both own.frob own.csv
  time,out
  0.000000000,1
  1.000000000,2
  2.000000000,3
  3.000000000,4
  4.000000000,1
  5.000000000,5

A mode that restarts itself, and several of them.

  $ cat > itself.frob <<'EOF'
  > main :: SF Float Float
  > main = switch (proc x -> (x, when (x > 1))) (\_ -> main)
  > EOF
  $ frobc check itself.frob 2>&1 | head -1
  error[E0402]: `main → main` may repeat endlessly within one instant
  $ cat > three.frob <<'EOF'
  > one, two, three :: SF Float Float
  > one = switch (proc x -> (x, when (x > 1))) (\_ -> two)
  > two = switch (proc x -> (x, when (x > 2))) (\_ -> three)
  > three = switch (proc x -> (x, when (x > 3))) (\_ -> one)
  > main = one
  > EOF
  $ frobc check three.frob 2>&1 | head -1
  error[E0402]: `one → two → three → one` may repeat endlessly within one instant

A number that may be infinite can become NaN when it is subtracted from itself, so this cycle may be
endless too: with a mode that receives 1/0.

  $ cat > infinite.frob <<'EOF'
  > go :: Float -> SF Float Float
  > go a = switch (proc x -> (x, when (not (max 0 (a - a) >= 0)))) (\_ -> go a)
  > main = switch (proc x -> (x, tag (edge (x > 1)) (x > 2))) (\c -> if c then go (1/0) else go 0)
  > EOF
  $ frobc check infinite.frob 2>&1 | head -1
  error[E0402]: `go → go` may repeat endlessly within one instant
  $ sed 's|a - a|a * x|' infinite.frob > times.frob
  $ frobc check times.frob 2>&1 | head -1
  error[E0402]: `go → go` may repeat endlessly within one instant
