If the initial value of a delay depends on a loop, that loop's result is known at the start, even
next to a loop over the same elements whose result is not.

  $ cat > start.frob <<'FROB'
  > main :: SF Float (Event Int, Event Int)
  > main = proc x -> (v, z) where
  >     z = delay (maximumBy (\_ -> 0) [NoEvent, NoEvent]) NoEvent
  >     v = minimumBy (\_ -> x) [NoEvent, NoEvent]
  > FROB
  $ printf 'time,in\n0,1\n1,2\n' > in.csv
  $ frobc trace --lint start.frob --input in.csv | tee compiled.csv
  time,out.1,out.2
  0.000000000,,
  1.000000000,,
  $ frobc trace start.frob --input in.csv --engine interp | cmp - compiled.csv
