The host judges assertions at each instant and reports them at the end. The outputs do not change.

  $ cat > speed.frob << FROB
  > import Past
  > main :: SF Velocity Velocity
  > main = proc v -> w where
  >     w = min 1[m/s] v
  >     assert "no faster than 1 m/s" (w <= 1[m/s])
  >     assert "input is small" (v < 3[m/s])
  >     assert "slows down" (respondsWithin 2[s] (v > 2[m/s], v < 1[m/s]))
  >     assert "stops at 100" (implies (v > 100[m/s]) (w == 0))
  >     assume "never six" (v /= 6[m/s])
  > FROB
  $ printf 'time,in\n0,0\n1,2.5\n2,2\n3,4\n4,1\n5,5\n5.5,6\n' > in.csv
  $ frobc trace speed.frob --input in.csv > out.csv
  assert "no faster than 1 m/s": held until an assumption failed at 5.500 s
  assert "input is small": violated, first at 3.000 s; in total at 2 instants
  assert "slows down": violated, first at 4.000 s; in total at 2 instants
  assert "stops at 100": not checked until an assumption failed at 5.500 s
  assume "never six": failed, first at 5.500 s; in total at 1 instant
  $ cat out.csv
  time,out
  0.000000000,0
  1.000000000,1
  2.000000000,1
  3.000000000,1
  4.000000000,1
  5.000000000,1
  5.500000000,1
  $ frobc trace speed.frob --input in.csv --asserts=off | cmp - out.csv
  $ frobc trace speed.frob --input in.csv --engine interp | cmp - out.csv
  $ sed '/assert/d; /assume/d; /Past/d' speed.frob > plain.frob
  $ frobc trace plain.frob --input in.csv | cmp - out.csv

As columns, with or without the summary:

  $ frobc trace speed.frob --input in.csv --asserts=off --probe assert
  time,out,probe.main.assert no faster than 1 m/s,probe.main.assert input is small,probe.main.assert slows down,probe.main.assert stops at 100,probe.main.assume never six
  0.000000000,0,Holds,Holds,NotAsked,NotAsked,Holds
  1.000000000,1,Holds,Holds,Open,NotAsked,Holds
  2.000000000,1,Holds,Holds,Open,NotAsked,Holds
  3.000000000,1,Holds,Fails,Open,NotAsked,Holds
  4.000000000,1,Holds,Holds,Fails,NotAsked,Holds
  5.000000000,1,Holds,Fails,Fails,NotAsked,Holds
  5.500000000,1,Holds,Fails,Fails,NotAsked,Fails

The first violation may end the run:

  $ frobc trace speed.frob --input in.csv --asserts=stop
  time,out
  0.000000000,0
  1.000000000,1
  2.000000000,1
  3.000000000,1
  assert "no faster than 1 m/s": held
  assert "input is small": violated, first at 3.000 s; in total at 1 instant
  assert "slows down": undecided at the end
  assert "stops at 100": never checked
  assume "never six": held
  error: "input is small" (speed.frob:6) was violated at 3.000 s
  [4]
  $ frobc trace speed.frob --input in.csv --asserts=stop --engine interp
  error: only the compiled program stops at assertions: use `--asserts=stop` with `--engine c`
  [2]

The C code contains nothing of the assertions unless an option enables them; the report states their
cost.

  $ frobc compile speed.frob -o with && frobc compile plain.frob -o without
  $ grep -c 'assert\|Past\|Verdict' with/speed.c with/speed.h
  with/speed.c:0
  with/speed.h:0
  [1]
  $ for file in with/speed.c without/plain.c; do sed '1,/\*\//d' $file | wc -l; done
  26
  26
  $ frobc compile speed.frob -o watched --asserts=count
  $ grep 'struct.*assert' watched/speed.h
      struct speed_verdict main_assert_no_faster_than_1_m_s;
      struct speed_verdict main_assert_input_is_small;
      struct speed_verdict main_assert_slows_down;
      struct speed_verdict main_assert_stops_at_100;
  $ frobc report speed.frob | tail -1
  assertions: 5; checking them adds 50 operations to a step (50.00 times the operations without checks) and 15 bytes to the state; if checking is off, the generated C does not contain them
  $ frobc report speed.frob --format json | grep -o '"assert[^,}]*'
  "assertions":5
  "assertion_operations":50
  "assertion_bytes":15
