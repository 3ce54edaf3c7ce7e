Signals computed from events, and events with memory.

  $ cat > input.csv <<EOF
  > time,in
  > 0,2
  > 1,
  > 2,5
  > 3,3
  > 4,
  > EOF
  $ run() { echo 'main :: SF (Event Int) ('"$1"')' > t.frob; echo "main = proc e -> $2" >> t.frob; frobc trace t.frob --input input.csv; }

`hold` shows an occurrence immediately, `dHold` one instant later:

  $ run 'Int, Int' '(hold 9 e, dHold 9 e)'
  time,out.1,out.2
  0.000000000,2,9
  1.000000000,2,2
  2.000000000,5,2
  3.000000000,3,5
  4.000000000,3,3

`accum` and similar functions include the first occurrence, even at the first
instant:

  $ run 'Event Int, Int, Int' '(accum 1 (mapE (*) e), accumHold 1 (mapE (*) e), dAccumHold 1 (mapE (*) e))'
  time,out.1,out.2,out.3
  0.000000000,2,2,1
  1.000000000,,2,2
  2.000000000,10,10,2
  3.000000000,30,30,10
  4.000000000,,30,30
  $ run 'Event Int, Int, Int' '(accumBy (-) 0 e, accumHoldBy (-) 0 e, dAccumHoldBy (-) 0 e)'
  time,out.1,out.2,out.3
  0.000000000,-2,-2,0
  1.000000000,,-2,-2
  2.000000000,-7,-7,-2
  3.000000000,-10,-10,-7
  4.000000000,,-10,-10

Counting and filtering occurrences:

  $ run 'Event Int, Event Int, Event Int, Event Int, Event Int' '(count e, once e, notYet e, takeEvents 2 e, dropEvents 2 e)'
  time,out.1,out.2,out.3,out.4,out.5
  0.000000000,1,2,,2,
  1.000000000,,,,,
  2.000000000,2,,5,5,
  3.000000000,3,,3,,3
  4.000000000,,,,,

Pointwise functions:

  $ run 'Event Int, Event (), Event Int, Event Int, Bool, Int' '(mapE (+ 1) e, tag e (), filterEvent (> 2) e, gate e False, isEvent e, fromEvent 0 e)'
  time,out.1,out.2,out.3,out.4,out.5,out.6
  0.000000000,3,(),,,true,2
  1.000000000,,,,,false,0
  2.000000000,6,(),5,,true,5
  3.000000000,4,(),3,,true,3
  4.000000000,,,,,false,0
  $ run 'Event Int, Event Int, Event Int, Event (Int, Int)' '(mergeE e (tag e 7), mergeR e (tag e 7), mergeBy (+) e (tag e 7), pairEvents e (filterEvent (> 2) e))'
  time,out.1,out.2,out.3,out.4
  0.000000000,2,7,9,
  1.000000000,,,,
  2.000000000,5,7,12,"(5, 5)"
  3.000000000,3,7,10,"(3, 3)"
  4.000000000,,,,

The value of another signal at an occurrence:

  $ run 'Event (Int, Time), Event Time' '(snapshot (e, time ()), sample (e, time ()))'
  time,out.1,out.2
  0.000000000,"(2, 0)",0
  1.000000000,,
  2.000000000,"(5, 2)",2
  3.000000000,"(3, 3)",3
  4.000000000,,

`atMin` and `atMax` store the instant of the best key; the earliest wins a tie, and NaN never
replaces another key:

  $ cat > best.frob <<EOF
  > main :: SF Float (Time, Time)
  > main = proc x -> (atMin (time (), x), atMax (time (), x))
  > EOF
  $ printf 'time,in\n0,nan\n1,3\n2,nan\n3,3\n4,5\n5,1\n' > keys.csv
  $ frobc trace best.frob --input keys.csv
  time,out.1,out.2
  0.000000000,0,0
  1.000000000,1,1
  2.000000000,1,1
  3.000000000,1,1
  4.000000000,1,4
  5.000000000,5,4
