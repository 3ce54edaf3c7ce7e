A test without a robot runs for its duration; a trial drives the program in the simulator, once with
each seed. Each has a line of output, and details if it fails.

  $ cat > around.frob << 'FROB'
  > import Past
  > import Robot
  > import Sources
  > import Trial
  > import WallFollow
  > 
  > main :: (HasSonar i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> wallFollow1 0.4[m] i where
  >     assert "is slow, \"always\"" (velocity i < 1[m/s]))
  > 
  > test "the wave stays small" = during 2[s] (proc () -> abs (sine 1[Hz] ()) <= 1)
  > 
  > test "a metre takes a second" = during 2[s] (proc () -> x < 1[m] where
  >     x = integral 1[m/s]
  >     assert "half, at first" (implies (time () < 0.5[s]) (x < 0.6[m])))
  > 
  > test "waits for what never comes" = during 1[s] (proc () -> by 3[s] False)
  > 
  > test "nothing is asked" = during 1[s] (proc () -> implies False True)
  > 
  > trial "touches nothing" = Trial {
  >     world = "room.toml",
  >     lasts = 20[s],
  >     seeds = 1 `to` 4,
  >     judge = neverTouches
  > }
  > 
  > trial "goes far in no time" = Trial {
  >     world = "room.toml",
  >     lasts = 20[s],
  >     seeds = 3 `to` 4,
  >     judge = comesFar 1[km] 1[s]
  > }
  > 
  > trial "is never near the wall" = Trial {
  >     world = "room.toml",
  >     lasts = 60[s],
  >     seeds = 1 `to` 2,
  >     judge = proc t -> neverTouches t where
  >         assert "far from all" (t.clearance > 0.5[m])
  >         assume "goes" (by 10[s] (t.driven > 0.1[m]))
  > }
  > FROB
  $ numbers () { sed -E 's/-?[0-9.]+(e-?[0-9]+)?, then -?[0-9.]+(e-?[0-9]+)?$/N, then N/; s/-?[0-9]+\.[0-9]{3}/N/g; s|world /[^ ]*/|world |; s/(--seed.* --at) [0-9.]+s/\1 Ns/'; }
  $ frobc test around.frob --robot pioneer > told
  [1]
  $ numbers < told
  ok    the wave stays small: 2 s
  FAIL  a metre takes a second: failed at N s
        frobc view failed/a-metre-takes-a-second.csv around.frob --robot pioneer --entry 'judge test a metre takes a second' --at 1s
  FAIL  waits for what never comes: undecided at the end, after 1 s
        frobc view failed/waits-for-what-never-comes.csv around.frob --robot pioneer --entry 'judge test waits for what never comes' --at 1s
  ok    nothing is asked: 1 s; never checked
  ok    touches nothing: 4 seeds, 20 s
  FAIL  goes far in no time: 2 of 2 seeds; seed 3: failed at N s
        x N m, y N m, heading N rad, clearance N m, N m driven, odometry off by N m
        collisions: 0
        out.forward: N, then N
        out.turn: N, then N
        probe.main.assert is slow, "always": Holds, then Holds
        picture: failed/goes-far-in-no-time-3.png
        frobc view failed/goes-far-in-no-time-3.csv around.frob --robot pioneer --world room.toml --seed 3 --at Ns
        a simpler run, without any of the world's disturbances, also fails: seed 3: failed at N s
          world: failed/goes-far-in-no-time-3-simpler.toml
          x N m, y N m, heading N rad, clearance N m, N m driven, odometry off by N m
          collisions: 0
          out.forward: N, then N
          out.turn: N, then N
          probe.main.assert is slow, "always": Holds, then Holds
          picture: failed/goes-far-in-no-time-3-simpler.png
          frobc view failed/goes-far-in-no-time-3-simpler.csv around.frob --robot pioneer --world failed/goes-far-in-no-time-3-simpler.toml --seed 3 --at Ns
  FAIL  is never near the wall: 2 of 2 seeds; seed 1: `far from all` violated at N s
        x N m, y N m, heading N rad, clearance N m, N m driven, odometry off by N m
        collisions: 0
        out.forward: N, then N
        out.turn: N, then N
        probe.main.assert is slow, "always": Holds, then Holds
        picture: failed/is-never-near-the-wall-1.png
        frobc view failed/is-never-near-the-wall-1.csv around.frob --robot pioneer --world room.toml --seed 1 --at Ns
        a simpler run, without any of the world's disturbances, also fails: seed 1: `far from all` violated at N s
          world: failed/is-never-near-the-wall-1-simpler.toml
          x N m, y N m, heading N rad, clearance N m, N m driven, odometry off by N m
          collisions: 0
          out.forward: N, then N
          out.turn: N, then N
          probe.main.assert is slow, "always": Holds, then Holds
          picture: failed/is-never-near-the-wall-1-simpler.png
          frobc view failed/is-never-near-the-wall-1-simpler.csv around.frob --robot pioneer --world failed/is-never-near-the-wall-1-simpler.toml --seed 1 --at Ns
  7 tests: 4 failed
  $ ls failed
  a-metre-takes-a-second.csv
  goes-far-in-no-time-3-simpler.csv
  goes-far-in-no-time-3-simpler.png
  goes-far-in-no-time-3-simpler.toml
  goes-far-in-no-time-3.csv
  goes-far-in-no-time-3.png
  is-never-near-the-wall-1-simpler.csv
  is-never-near-the-wall-1-simpler.png
  is-never-near-the-wall-1-simpler.toml
  is-never-near-the-wall-1.csv
  is-never-near-the-wall-1.png
  waits-for-what-never-comes.csv

The outcome does not depend on the number of processes, and tools can read it.

  $ frobc test around.frob --robot pioneer --json -j 1 > one
  [1]
  $ frobc test around.frob --robot pioneer --json -j 5 | cmp - one
  $ sed -n 1,4p one
  {"file":"around.frob","label":"the wave stays small","ok":true,"lasts":2,"runs":[{"fate":"held","at":2,"by":""}]}
  {"file":"around.frob","label":"a metre takes a second","ok":false,"lasts":2,"runs":[{"fate":"violated","at":1,"by":"judge"}],"picture":"","view":"frobc view failed/a-metre-takes-a-second.csv around.frob --robot pioneer --entry 'judge test a metre takes a second' --at 1s"}
  {"file":"around.frob","label":"waits for what never comes","ok":false,"lasts":1,"runs":[{"fate":"undecided","at":1,"by":"judge"}],"picture":"","view":"frobc view failed/waits-for-what-never-comes.csv around.frob --robot pioneer --entry 'judge test waits for what never comes' --at 1s"}
  {"file":"around.frob","label":"nothing is asked","ok":true,"lasts":1,"runs":[{"fate":"unasked","at":1,"by":""}]}
  $ frobc test around.frob --robot pioneer -k takes --junit tests.xml
  FAIL  a metre takes a second: failed at 1.000 s
        frobc view failed/a-metre-takes-a-second.csv around.frob --robot pioneer --entry 'judge test a metre takes a second' --at 1s
  1 test: 1 failed
  [1]
  $ cat tests.xml
  <?xml version="1.0" encoding="UTF-8"?>
  <testsuite name="frobc test" tests="1" failures="1" skipped="0">
    <testcase classname="around.frob" name="a metre takes a second">
      <failure message="failed at 1.000 s">frobc view failed/a-metre-takes-a-second.csv around.frob --robot pioneer --entry 'judge test a metre takes a second' --at 1s</failure>
    </testcase>
  </testsuite>
  $ frobc test around.frob --robot pioneer -k 'touches' --seeds 2
  ok    touches nothing: 2 seeds, 20 s
  1 test: all hold

The printed command shows the run: it compiles, and the recording is the program's.

  $ view=$(sed -n 's/^ *\(frobc view .* --seed .*\)/\1/p' told | head -1)
  $ echo "$view" | numbers
  frobc view failed/goes-far-in-no-time-3.csv around.frob --robot pioneer --world room.toml --seed 3 --at Ns
  $ frobc view --only-build $(echo "$view" | cut -d' ' -f3-) > built && test -s "$(cat built)"
  $ frobc trace around.frob --robot pioneer --input failed/goes-far-in-no-time-3.csv --output again.csv
  assert "is slow, "always"": held

The measurements of a trial are summarized over its seeds, and listed for each
run for tools.

  $ cat > measures.frob << 'FROB'
  > import Robot
  > import Trial
  > import WallFollow
  > main :: (HasSonar i, DiffDrive o) => Program i o
  > main = reactimateRobot (wallFollow1 0.4[m])
  > trial "goes" = Trial {
  >     world = "room.toml",
  >     lasts = 3[s],
  >     seeds = 4 `to` 6,
  >     judge = bothOf neverTouches (proc t -> atEnd (way < 3[m]) where
  >         way = lastOf t.driven
  >         third = meanOf third1
  >         third1 = if time () > 1.99[s] then 3[s] else 0
  >         least = smallestOf (time () + 2[s])
  >         most = largestOf (time ()))
  > }
  > trial "has come to its end" = Trial {
  >     world = "room.toml",
  >     lasts = 1[s],
  >     seeds = 1 `to` 1,
  >     judge = proc t -> atEnd (mean > 0.5[s]) where
  >         mean = meanOf (time () + 0 * t.driven / 1[m/s])
  >         none = meanOf (0[m] / 0)
  > }
  > FROB
  $ frobc test measures.frob --robot pioneer > told
  [1]
  $ sed 's/way: .*/way/; /^  *[xop]/d; /frobc view/d' told
  ok    goes: 3 seeds, 3 s
        way
        third: mean 1.013 s, deviation 0, from 1.013 (seed 4) to 1.013 (seed 4)
        least: mean 2 s, deviation 0, from 2 (seed 4) to 2 (seed 4)
        most: mean 3 s, deviation 0, from 3 (seed 4) to 3 (seed 4)
  FAIL  has come to its end: 1 of 1 seed; seed 1: undecided at the end, after 1 s
        mean: 0.5 s
        none: not measured
        collisions: 0
        a simpler run, without any of the world's disturbances, also fails: seed 1: undecided at the end, after 1 s
          world: failed/has-come-to-its-end-1-simpler.toml
          collisions: 0
  2 tests: 1 failed
  $ frobc test measures.frob --robot pioneer --json -k end | sed -E 's/.*("measured":.*)\}\],.*/\1/'
  "measured":{"mean":0.5}
  $ sed 's/mean > /mean >= /; /none/d' measures.frob > ends.frob
  $ frobc test ends.frob --robot pioneer -k end
  ok    has come to its end: 1 seed, 1 s
        mean: 0.5 s
  1 test: all hold

Compiled programs contain nothing of the tests.

  $ mkdir plain && sed '/^test/,$d; /Past/d; /Trial/d; /Sources/d' around.frob > plain/around.frob
  $ frobc compile around.frob --robot pioneer -o with && frobc compile plain/around.frob --robot pioneer -o without
  $ sed -i '1,/\*\//d' with/around.c without/around.c    # the sums of the sources
  $ diff with/around.c without/around.c | grep '^[<>]' | sed 's/line [0-9]*//'
  < /* main, around.frob:8 */
  > /* main, around.frob:5 */
  <     around_wallFollow1_reset(self);                         /*  */
  >     around_wallFollow1_reset(self);                         /*  */
  <     around_wallFollow1_step(self, dt, in, &i_sonar, &forward, &turn); /*  */
  >     around_wallFollow1_step(self, dt, in, &i_sonar, &forward, &turn); /*  */

Errors are reported before anything runs, or in place of a result.

  $ cat > wrong.frob << 'FROB'
  > import Trial
  > param n :: Time = 3[s]
  > main :: SF Float Float
  > main = proc x -> x
  > test "backwards" = during (0 - 1[s]) (proc () -> True)
  > test "whatever is set" = during n (proc () -> True)
  > trial "upside down" = Trial { world = "room.toml", lasts = 60[s], seeds = 20 `to` 2, judge = neverTouches }
  > FROB
  $ frobc test wrong.frob
  error[E0392]: a test must last more than 0 s and at most 100,000 s, but this one lasts -1 s
   --> wrong.frob:5:1
    |
  5 | test "backwards" = during (0 - 1[s]) (proc () -> True)
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  
  error[E0392]: a test must be a constant, but this one depends on the parameter `n`, which can be set for each run
   --> wrong.frob:6:1
    |
  6 | test "whatever is set" = during n (proc () -> True)
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  
  error[E0392]: the first seed must be at least 1, and the last seed must not be less than the first, but these seeds are 20 to 2
   --> wrong.frob:7:1
    |
  7 | trial "upside down" = Trial { world = "room.toml", lasts = 60[s], seeds = 20 `to` 2, judge = neverTouches }
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  
  3 errors
  [1]
  $ sed -i '/^test/d; s/20 `to` 2/1 `to` 2/; /^param/d' wrong.frob
  $ frobc test wrong.frob
  FAIL  upside down: wrong is not a robot program; use `reactimateRobot` to make one
  1 test: 1 failed
  [1]
  $ sed -i 's/room/no_such_room/' wrong.frob
  $ frobc test wrong.frob
  FAIL  upside down: there is no world `no_such_room.toml` next to wrong.frob or among the worlds that come with frobc: room.toml
  1 test: 1 failed
  [1]
  $ printf 'import Trial\ntest "a" = 3\ntest "a" = during 1[s] (proc () -> True)\n' > twice.frob
  $ frobc test twice.frob
  error[E0211]: the name `test a` is defined twice
   --> twice.frob:3:6
    |
  2 | test "a" = 3
    |      --- first defined here
  3 | test "a" = during 1[s] (proc () -> True)
    |      ^^^
    |
    = hint: remove one of them, or rename it
  
  1 error
  [1]
  $ frobc test around.frob --robot pioneer -k nothing-like-it
  error: no test has `nothing-like-it` in its label
  [2]
  $ mkdir empty && frobc test empty
  error: there are no tests here: write `test "…" = …` or `trial "…" = …`
  [2]
  $ frobc test no_such.frob
  error: there is no file no_such.frob
  [2]
  $ frobc test around.frob --robot pioneer --seeds 0
  error: --seeds must be at least 1
  [2]

An error in the program is reported once, however many of its tests need it.

  $ cat > open.frob << 'FROB'
  > import Robot
  > import Trial
  > import WallFollow
  > main :: (HasSonar i, DiffDrive o) => Program i o
  > main = reactimateRobot (wallFollow1 0.3[m])
  > trial "one" = Trial { world = "room.toml", lasts = 1[s], seeds = 1 `to` 2, judge = neverTouches }
  > trial "another" = Trial { world = "room.toml", lasts = 2[s], seeds = 1 `to` 2, judge = neverTouches }
  > FROB
  $ frobc test open.frob 2> complaints
  FAIL  one: does not compile
  FAIL  another: does not compile
  2 tests: 2 failed
  [1]
  $ grep -c '^error' complaints
  1
