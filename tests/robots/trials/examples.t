What the examples promise of themselves holds, on each robot that they are for.

  $ examples=../../../examples
  $ frobc test $examples | grep -v '^      '
  skip  the tracker of parts finds what the whole one does: needs C, in blob.c
  ok    gets to the goal, past all that is in the way: 3 seeds, 240 s
  ok    drives to the end of the corridor: 10 seeds, 35 s
  ok    keeps to the middle, to the end: 3 seeds, 28 s
  ok    drives into the dock: 10 seeds, 40 s
  ok    docks within 2 cm and 2 degrees: 20 seeds, 20 s
  ok    goes on and on: 3 seeds, 300 s
  ok    keeps a metre behind the ball, and touches nothing: 2 seeds, 45 s
  ok    comes to its speed, and says when it is there: 4 s
  ok    holds its course, and stops before the wall: 10 seeds, 25 s
  skip  is at the lamp in time and touches nothing: needs the robot Moth, with its body in C
  ok    follows the tape round: 2 seeds, 60 s
  ok    follows the tape three times round: 3 seeds, 220 s
  ok    goes to and fro and touches nothing: 3 seeds, 180 s
  ok    drives up to the poster: 2 seeds, 16 s
  ok    goes round the room and touches nothing: 10 seeds, 60 s
  14 tests: all hold; 2 skipped
  $ for robot in pioneer scout create; do
  >   for name in bug corridor dock explore; do frobc test $examples/$name/$name.frob --robot $robot --seeds 2 | head -1; done
  > done
  ok    gets to the goal, past all that is in the way: 2 seeds, 240 s
  ok    drives to the end of the corridor: 2 seeds, 35 s
  ok    drives into the dock: 2 seeds, 40 s
  ok    goes on and on: 2 seeds, 300 s
  ok    gets to the goal, past all that is in the way: 2 seeds, 240 s
  ok    drives to the end of the corridor: 2 seeds, 35 s
  ok    drives into the dock: 2 seeds, 40 s
  ok    goes on and on: 2 seeds, 300 s
  ok    gets to the goal, past all that is in the way: 2 seeds, 240 s
  ok    drives to the end of the corridor: 2 seeds, 35 s
  ok    drives into the dock: 2 seeds, 40 s
  ok    goes on and on: 2 seeds, 300 s

What needs C runs if its files are named, as it is told to.

  $ frobc test $examples/light_seek $examples/blob_tracker | sed -n 's/^      //p' > commands
  error: no test was run; what runs those skipped is above
  $ sed "s|$examples/||g" commands
  frobc test light_seek/light_seek.frob --robot light_seek/Moth.frob --with light_seek/moth_body.c
  frobc test blob_tracker/blob_tracker.frob --with blob_tracker/blob.c
  $ sh commands
  ok    is at the lamp in time and touches nothing: 10 seeds, 60 s
  1 test: all hold
  ok    the tracker of parts finds what the whole one does: 4 s
  1 test: all hold
  $ frobc test $examples/light_seek > /dev/null
  error: no test was run; what runs those skipped is above
  [2]
  $ frobc test $examples/light_seek $examples/from_c --junit left.xml --json | grep -o '"skipped".*'
  "skipped":"needs the robot Moth, with its body in C","command":"frobc test ../../../examples/light_seek/light_seek.frob --robot ../../../examples/light_seek/Moth.frob --with ../../../examples/light_seek/moth_body.c"}
  $ grep -c skipped left.xml
  2

Named, they have to run.

  $ frobc test $examples/blob_tracker/blob_tracker.frob
  FAIL  the tracker of parts finds what the whole one does: cannot be run
  1 test: 1 failed
  error: the program calls `blob_brighter`, `blob_measure`, `blob_around` in C, which no C file of it mentions: name the C files with `--with FILE.c` (without a file there are only the functions of <math.h> that docs/foreign.md lists)
  [1]
