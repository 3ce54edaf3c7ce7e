Any proc may contain an assertion. It is judged while its signal function runs: in a mode while the
mode runs, and in each element of `mapSF`. Assertions with the same label are distinguished by their
paths.

  $ cat > three.frob << FROB
  > main :: SF (Array 2 Distance) (Array 2 Distance)
  > main = proc xs -> mapSF one xs where
  >     assert "in all" (sum xs < 2.5[m])
  > 
  > one :: SF Distance Distance
  > one = proc x -> switch low high x
  > 
  > low :: SF Distance (Distance, Event Distance)
  > low = proc x -> (x, e) where
  >     e = tag (edge (x > 1[m])) x
  >     assert "it stays */ so" (x <= 1[m])
  > 
  > high :: Distance -> SF Distance Distance
  > high w = proc x -> w where
  >     assert "it stays */ so" (x > 0.5[m])
  >     assert "static" (w > 1[m])
  > FROB
  $ printf 'time,in[0],in[1]\n0,0,0\n1,2,0\n2,0.1,2\n' > in.csv
  $ frobc trace three.frob --input in.csv --probe assert
  time,out[0],out[1],probe.main.assert in all,probe.one.one.assert it stays */ so[0],probe.one.one.assert it stays */ so[1],probe.high.assert it stays */ so[0],probe.high.assert it stays */ so[1],probe.high.assert static[0],probe.high.assert static[1]
  0.000000000,0,0,Holds,Holds,Holds,,,,
  1.000000000,2,0,Holds,,Holds,Holds,,Holds,
  2.000000000,2,2,Holds,,,Fails,Holds,Holds,Holds
  assert "in all": held
  assert "it stays */ so" (one.one.assert it stays */ so): held
  assert "it stays */ so" (high.assert it stays */ so): violated, first at 2.000 s; in total at 1 instant
  assert "static": held

Assertions in tasks, and in the equations of a `do`; elsewhere the keywords are
ordinary names.

  $ cat > steps.frob << FROB
  > assert :: String -> Float -> Float
  > assert _ x = x
  > 
  > main :: SF Float Float
  > main = proc x -> do
  >     y <- delay 0 -< assume
  >     let assume = assert "x" x
  >         assert "above" (y >= 0)
  >     returnA -< y + assume
  > FROB
  $ printf 'time,in\n0,1\n1,-1\n2,3\n' > in.csv
  $ frobc trace steps.frob --input in.csv
  time,out
  0.000000000,1
  1.000000000,0
  2.000000000,2
  assert "above": violated, first at 2.000 s; in total at 1 instant

Assertions in other places, and assertions that are not of type Bool, are
rejected.

  $ cat > wrong.frob << FROB
  > half :: Float -> Float
  > half x = y where
  >     y = x / 2
  >     assert "smaller" (y < x)
  > 
  > main :: SF Float Float
  > main = proc x -> half x where
  >     assert "same" (x > 0)
  >     assert "same" (x > 1)
  >     assert "" (x > 0)
  > FROB
  $ frobc check wrong.frob
  error[E0234]: an `assert` is only allowed among the equations of a `proc`
   --> wrong.frob:4:5
    |
  4 |     assert "smaller" (y < x)
    |     ^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: move it into a `proc`, as in `proc x -> y where` with `assert "label" (y > 0)` on a line below
  
  error[E0212]: two assertions here have the same label
   --> wrong.frob:9:12
    |
  8 |     assert "same" (x > 0)
    |            ------ the first
  9 |     assert "same" (x > 1)
    |            ^^^^^^
  
  error[E0235]: this label is empty or contains a line break
    --> wrong.frob:10:12
     |
  10 |     assert "" (x > 0)
     |            ^^
     |
     = hint: describe in a few words what must hold; the summary of a run shows the label
  
  3 errors
  [1]
  $ cat > number.frob << FROB
  > main :: SF Float Float
  > main = proc x -> x where
  >     assert "number" x
  >     assert "event" (edge (x > 1))
  > FROB
  $ frobc check number.frob
  error[E0360]: `Float` is not a condition
   --> number.frob:3:21
    |
  3 |     assert "number" x
    |                     ^
    |
    = hint: assert a condition: compare the value with a limit, as in `(x <= 1)`
  
  error[E0360]: `Event ()` is not a condition
   --> number.frob:4:21
    |
  4 |     assert "event" (edge (x > 1))
    |                     ^^^^^^^^^^^^
    |
    = hint: use `isEvent (edge (x > 1))`, which is True when the event occurs
  
  2 errors
  [1]
  $ cat > nothing.frob << FROB
  > main :: SF Float Float
  > main = proc x -> x where
  >     assert "nothing"
  > FROB
  $ frobc check nothing.frob
  error[E0110]: expected the condition that must hold, found the end of the block
   --> nothing.frob:3:21
    |
  3 |     assert "nothing"
    |                     ^
    |
    = hint: write, for example, `assert "keeps off the wall" (clearance > 0.1[m])`
  
  1 error
  [1]

An assertion in a switch that depends on its own output:

  $ cat > fed.frob << FROB
  > main :: SF Float Float
  > main = proc x -> y where
  >     y = switch (proc (u, _) -> (u, edge (u > 1))) (\\_ -> late) (x, y)
  >     assert "bounded" (y < 3)
  > 
  > late :: SF (Float, Float) Float
  > late = proc (u, v) -> 2 * u where
  >     assert "not watched" (v < 10)
  > FROB
  $ printf 'time,in\n0,1\n1,2\n' > in.csv
  $ frobc trace fed.frob --input in.csv
  warning[W0311]: this assertion is not checked
   --> fed.frob:8:12
    |
  8 |     assert "not watched" (v < 10)
    |            ^^^^^^^^^^^^^
    |
    = note: it is inside a switch whose output is fed back to it, and showing an inner signal would make all outputs of the switch depend on that signal
    = hint: move the assertion to where the output of the switch is used
  
  1 warning
  time,out
  0.000000000,1
  1.000000000,4
  assert "bounded": violated, first at 1.000 s; in total at 1 instant
