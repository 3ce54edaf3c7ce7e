Twelve programs that engineers write, each short because the library has the parts. Each has at most
40 lines, with its tests, its comments and its blank lines; the tests hold with both precisions of
Float.

  $ cd programs
  $ judged() { # judged PROGRAM: checks, formats and tests it
  >     frobc check "$1.frob"
  >     frobc format --check "$1.frob"
  >     lines=$(wc -l <"$1.frob")
  >     if [ "$lines" -le 40 ]; then echo "$1: at most 40 lines"; else echo "$1: $lines lines"; fi
  >     frobc test "$1.frob"
  >     frobc test --real float "$1.frob" >float || cat float
  > }
  $ for program in *.frob; do judged "${program%.frob}"; done
  encoder: at most 40 lines
  ok    the difference of two values survives the wrap, in both directions: 0.001 s
  ok    measures the speed of a wheel forwards and backwards through the wrap: 20 s
  2 tests: all hold
  fusion: at most 40 lines
  ok    knows its pose in spite of bias, noise and slip: 60 s
  1 test: all hold
  leader: at most 40 lines
  ok    is near the place where the leader was two seconds ago: 20 s
  1 test: all hold
  lift: at most 40 lines
  ok    serves 1 on its way to 3 and 0 at last, and moves only with a closed door: 60 s
  1 test: all hold
  pendulum: at most 40 lines
  ok    stands up from 15 degrees, and returns to the middle: 8 s
  1 test: all hold
  potential: at most 40 lines
  ok    gets past the table that stands across its way: 2 seeds, 60 s
  1 test: all hold
  pursuit: at most 40 lines
  ok    drives one lap, stays near the path, and touches nothing: 2 seeds, 50 s
  1 test: all hold
  retries: at most 40 lines
  ok    pauses for 1, 2, 4 and 4 s and then gives up: 20 s
  ok    ends with success in the second attempt: 4 s
  2 tests: all hold
  sonars: at most 40 lines
  ok    two wrong echoes in five change nothing, on any of the sonars: 10 s
  ok    comes to rest before the wall: 2 seeds, 30 s
  2 tests: all hold
  stick: at most 40 lines
  ok    the shape has a dead zone, ends at 1, and is odd: 0.001 s
  ok    stops at once, and stays stopped until go with the stick at rest: 6 s
  ok    drives again after go, and gains at most 0.8 m/s in a second: 4 s
  3 tests: all hold
  subsumption: at most 40 lines
  ok    an escape lasts 1 s and wins over everything else: 2 s
  ok    dodges only what has been near for 0.1 s: 1 s
  ok    drives on and touches nothing: 2 seeds, 60 s
  3 tests: all hold
  vfh: at most 40 lines
  ok    gets to the other side of the table and touches nothing: 2 seeds, 40 s
  1 test: all hold

The interpreter computes the same verdicts at each instant of the tests, and the
same commands to the robots.

  $ awk 'BEGIN { print "time"; for (k = 0; k < 500; k++) print k / 50 }' >steps.csv
  $ agree() { # agree NAME ARGUMENTS...: traces in both engines
  >     name=$1
  >     shift
  >     frobc trace "$name.frob" "$@" >c.csv
  >     frobc trace --engine interp "$name.frob" "$@" | cmp - c.csv && echo "$name: $(wc -l <c.csv) lines"
  > }
  $ for program in *.frob; do
  >     sed -n 's/^test \("[^"]*"\) =.*/judge test \1/p' "$program" | tr -d '"' | while read -r entry; do
  >         agree "${program%.frob}" --entry "$entry" --input steps.csv
  >     done
  > done
  encoder: 501 lines
  encoder: 501 lines
  fusion: 501 lines
  leader: 501 lines
  lift: 501 lines
  pendulum: 501 lines
  retries: 501 lines
  retries: 501 lines
  sonars: 501 lines
  stick: 501 lines
  stick: 501 lines
  stick: 501 lines
  subsumption: 501 lines
  subsumption: 501 lines
  $ for name in potential pursuit sonars subsumption vfh; do
  >     world=$(sed -n 's/.*world = "\(.*\)",.*/\1/p' "$name.frob")
  >     frobc run "$name.frob" --world "$world" --for 20s --record "$name.csv" >/dev/null
  >     agree "$name" --robot pioneer --input "$name.csv"
  > done
  potential: 1002 lines
  pursuit: 1002 lines
  sonars: 1002 lines
  subsumption: 1002 lines
  vfh: 1002 lines
