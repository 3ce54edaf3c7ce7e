Sources of events: whether they occur at the first instant, and when afterwards.

  $ cat > clocks.frob <<EOF
  > main :: SF () (Event Bool, Event (), Event (), Event (), Event (), Event (), Event ())
  > main = proc _ -> (now True (), after 0 (), after 0.25[s] (), ago 1[s] (), every 0 (), every 0.2[s] (), never ())
  > ago q = after (-q)
  > EOF
  $ printf 'time\n5\n5.1\n5.2\n5.3\n5.9\n6\n6\n' > times.csv
  $ frobc trace clocks.frob --input times.csv
  time,out.1,out.2,out.3,out.4,out.5,out.6,out.7
  5.000000000,true,(),,(),,,
  5.100000000,,,,,(),,
  5.200000000,,,,,(),(),
  5.300000000,,,(),,(),,
  5.900000000,,,,,(),(),
  6.000000000,,,,,(),(),
  6.000000000,,,,,(),,

`after NaN` and `every infinity` never occur; ten steps of 0.1 s are 1 s, so
`after 1[s]` and `every 1[s]` occur at the tenth:

  $ cat > exact.frob <<EOF
  > main :: SF () (Event (), Event (), Event (), Event ())
  > main = proc _ -> (after (0[s] / 0) (), every (1[s] / 0) (), after 1[s] (), every 1[s] ())
  > EOF
  $ (echo time; for n in 0 1 2 3 4 5 6 7 8 9; do echo 0.$n; done; echo 1.0; echo 1.1) > times.csv
  $ frobc trace exact.frob --input times.csv | tail -2
  1.000000000,,,(),()
  1.100000000,,,,

`ticks` counts nanoseconds, and `timeSince` restarts when its input is True:

  $ cat > counted.frob <<EOF
  > main :: SF Bool (Bool, Bool, Bool, Bool, Time)
  > main = proc b -> (ticks 200000000 (), ticks 300000000.9 (), ticks 0.9 (), ticks (0 / 0) (), timeSince b)
  > EOF
  $ printf 'time,in\n0,false\n0.2,false\n0.3,true\n0.4,false\n1,false\n1.1,true\n' > times.csv
  $ frobc trace counted.frob --input times.csv
  time,out.1,out.2,out.3,out.4,out.5
  0.000000000,false,false,true,false,0
  0.200000000,true,false,true,false,0.20000000000000001
  0.300000000,false,true,true,false,0
  0.400000000,true,false,true,false,0.10000000000000001
  1.000000000,true,true,true,false,0.69999999999999996
  1.100000000,false,false,true,false,0

Edges of Bools: `edge` and `falling` never occur at the first instant, `edgeFrom
False` may; `when` is not an edge.

  $ cat > edges.frob <<EOF
  > main :: SF Bool (Event (), Event (), Event (), Event Int, Event ())
  > main = proc b -> (edge b, falling b, edgeFrom False b, edgeTag 7 b, when b)
  > EOF
  $ printf 'time,in\n0,true\n1,true\n2,false\n3,true\n4,false\n' > truth.csv
  $ frobc trace edges.frob --input truth.csv
  time,out.1,out.2,out.3,out.4,out.5
  0.000000000,,,(),,()
  1.000000000,,,,,()
  2.000000000,,(),,,
  3.000000000,(),,(),7,()
  4.000000000,,(),,,

Values that appear or change:

  $ cat > changes.frob <<EOF
  > main :: SF (Maybe Int, Float) (Event Int, Event Float)
  > main = proc (m, x) -> (edgeJust m, change x)
  > EOF
  $ printf 'time,in.1,in.2\n0,Just 1,1\n1,Just 2,1\n2,Nothing,2\n3,Just 3,2\n4,Just 4,nan\n5,Nothing,nan\n' > values.csv
  $ frobc trace changes.frob --input values.csv
  time,out.1,out.2
  0.000000000,,
  1.000000000,,
  2.000000000,,2
  3.000000000,3,
  4.000000000,,nan
  5.000000000,,nan
