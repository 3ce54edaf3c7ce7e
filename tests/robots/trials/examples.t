What the examples promise of themselves holds, on each robot that they are for.

  $ examples=../../../examples
  $ frobc test $examples | grep -v '^      '
  skip  the tracker of parts finds what the whole one does: needs C, in blob.c
  ok    gets to the goal, past all that is in the way: 3 seeds, 240 s
  ok    gives up a goal that is walled in: 3 seeds, 180 s
  ok    needs not drive where it is at the goal: 1 s
  ok    goes round once and on to the place nearest to the goal: 31 s
  ok    says where that has brought it no nearer, and gives up then: 50 s
  ok    goes for five seconds before it looks whether it is round: 6 s
  ok    goes along the wall 0.3 m from it: 4 s
  ok    drives to the end of the corridor: 10 seeds, 35 s
  ok    comes back by 0.6 of its way off the middle each second: 3 s
  ok    turns by 6 rad for each metre that it comes back too little: 1 s
  ok    comes back at no more than half its speed: 1 s
  ok    turns no faster than 60 degrees a second: 1 s
  ok    drives at its speed, and slows down before the end: 1 s
  ok    ends with how far it has come: 15 s
  ok    keeps to the middle, to the end: 3 seeds, 28 s
  ok    drives into the dock: 10 seeds, 40 s
  ok    gives up where the dock is walled up: 3 seeds, 150 s
  ok    turns on the spot, no faster than 45 degrees a second: 1 s
  ok    turns by 2 rad/s for each radian, and ends 2 degrees before: 4 s
  ok    enters at 0.12 m/s, slower where the end is near: 1 s
  ok    keeps its direction where the walls of the dock are not near: 1 s
  ok    looks 2 rad to the middle of the dock for each metre of difference, up to 20 degrees: 1 s
  ok    turns no faster than 30 degrees a second: 1 s
  ok    a wall is the end only where the dock is deep enough, and near: 1 s
  ok    tries three times, with a limit of time for each step: 320 s
  ok    docks within 2 cm and 2 degrees: 20 seeds, 20 s
  ok    goes on and on: 3 seeds, 300 s
  ok    drives at 0.3 m/s until something is nearer than 0.4 m ahead: 3 s
  ok    steers away from what is nearer than 0.35 m on a side, by 4 rad/s for each metre: 1 s
  ok    a stretch ends where something is near, after a bump, or after 15 s: 16 s
  ok    backs up for 1.5 s, or until it bumps into something behind: 2 s
  ok    looks for 0.3 s where there is more room, and turns there at 70 degrees a second: 1 s
  ok    turns for as long as it should, until the way is free, and no longer than 6 s: 7 s
  ok    each turn lasts longer than the one before, and after the fifth all over again: 1 s
  ok    backs up after each bump, and turns away for longer than before: 9 s
  ok    keeps a metre behind the ball, and touches nothing: 2 seeds, 45 s
  ok    comes to its speed, and says when it is there: 4 s
  ok    holds its course, and stops before the wall: 10 seeds, 25 s
  ok    turns by 2 rad/s for each radian, and by 0.3 more each second that it stays off: 3 s
  ok    turns less while it comes back: by a tenth of how fast it does: 2 s
  ok    turns no faster than 60 degrees a second: 1 s
  ok    half a metre before an obstacle it stands, and is faster by 0.5 m/s for each metre: 1 s
  ok    gets going and brakes by 0.3 m/s in a second: 4 s
  skip  is at the lamp in time and touches nothing: needs the robot Moth, with its body in C
  ok    follows the tape round: 2 seeds, 60 s
  ok    follows the tape three times round: 3 seeds, 220 s
  ok    finds the line behind a corner, and stops where it ends: 3 seeds, 40 s
  ok    drives at 0.25 m/s in the middle, at 0.4 of that with the line on one side: 1 s
  ok    turns to the line, by 60 degrees a second for the whole difference: 1 s
  ok    a line that was not seen for 0.2 s is lost, on the side where it was: 2 s
  ok    what is darker than 0.7 is the line, on either side: 1 s
  ok    searches 120 degrees to the one side, then as far to the other: 7 s
  ok    ends its search where it finds the line, on the one side or the other: 6 s
  ok    drives ahead to the line, and gives up after 20 s without: 21 s
  ok    goes to and fro and touches nothing: 3 seeds, 180 s
  ok    looks round: a full turn to the left in six seconds: 7 s
  ok    goes round for eight seconds, 0.3 m from the wall on its left: 9 s
  ok    looks round at each end, and turns back: 55 s
  ok    goes on to the same place when it has gone round what was in the way: 40 s
  ok    drives up to the poster: 2 seeds, 16 s
  ok    goes round the room, 0.2 m from the wall, and touches nothing: 10 seeds, 60 s
  ok    limits to both sides: 1 s
  ok    comes to its distance by 1.2 of the way each second: 3 s
  ok    turns by 8 rad for each metre that it comes too little: 1 s
  ok    comes at no more than 50 degrees to the wall: 1 s
  ok    slows down before what is ahead, and backs away from it: 1 s
  65 tests: all hold; 2 skipped
  $ for robot in pioneer scout create; do
  >   for name in bug corridor dock explore patrol; do
  >     frobc test $examples/$name/$name.frob --robot $robot --seeds 2 | tail -1
  >   done
  > done
  7 tests: all hold
  7 tests: all hold
  10 tests: all hold
  9 tests: all hold
  5 tests: all hold
  7 tests: all hold
  7 tests: all hold
  10 tests: all hold
  9 tests: all hold
  5 tests: all hold
  7 tests: all hold
  7 tests: all hold
  10 tests: all hold
  9 tests: all hold
  5 tests: all hold

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
