The trials of the examples succeed, on each robot that they are for.

  $ examples=../../../examples
  $ frobc test $examples | grep -v '^      '
  skip  finds the same blob with both trackers: needs C code in blob.c
  ok    reaches the goal and touches nothing: 3 seeds, 240 s
  ok    passes three obstacles on the way to the goal: 3 seeds, 240 s
  ok    gives up if the goal is walled in: 3 seeds, 180 s
  ok    ends at once if it is at the goal already: 1 s
  ok    drives round once, then on to the place nearest to the goal: 31 s
  ok    gives up if the way round has brought it no nearer to the goal: 50 s
  ok    follows the wall for five seconds before it checks whether it is round: 6 s
  ok    keeps 0.3 m away from the wall: 4 s
  ok    drives to the end of the corridor and touches nothing: 10 seeds, 35 s
  ok    keeps to the middle of the corridor, and stops before its end: 10 seeds, 35 s
  ok    returns to the middle by 0.6 of the distance each second: 3 s
  ok    turns by 6 rad/s for each m/s by which it returns too slowly: 1 s
  ok    returns to the middle at no more than half its speed: 1 s
  ok    turns no faster than 60 degrees a second: 1 s
  ok    drives at its speed, and slows down before the end of the corridor: 1 s
  ok    ends with the distance from the start: 15 s
  ok    drives to the end of the corridor and touches nothing: 1 seed, 28 s
  ok    keeps within 5 cm of the middle: 3 seeds, 28 s
  ok    drives into the dock and touches nothing: 10 seeds, 40 s
  ok    stops in the middle of the dock and looks inward: 10 seeds, 40 s
  ok    gives up after three attempts if the dock is walled up: 3 seeds, 150 s
  ok    turns on the spot, no faster than 45 degrees a second: 1 s
  ok    turns by 2 rad/s for each radian, and ends 2 degrees before the direction: 4 s
  ok    enters at 0.12 m/s, and more slowly near the end: 1 s
  ok    keeps its direction until both walls of the dock are near: 1 s
  ok    steers to the middle of the dock by 2 rad for each metre of difference, up to 20 degrees: 1 s
  ok    turns no faster than 30 degrees a second: 1 s
  ok    takes a wall for the end of the dock only if the wall is near and the dock deep enough: 1 s
  ok    makes three attempts, with a time limit for each step: 140 s
  ok    docks in time: 3 seeds, 20 s
  ok    docks within 2 cm and 2 degrees: 20 seeds, 20 s
  ok    drives on for five minutes without getting stuck: 3 seeds, 300 s
  ok    gets half a metre away from every place within a minute: 3 seeds, 300 s
  ok    drives at 0.3 m/s until something is nearer than 0.4 m ahead: 3 s
  ok    steers away from obstacles at a side that are nearer than 0.35 m, by 4 rad/s for each metre: 1 s
  ok    ends a stretch if something is near ahead, after a bump, or after 15 s: 16 s
  ok    backs up for 1.5 s, or until it bumps into something behind: 2 s
  ok    looks for 0.3 s which side has more room, and turns there at 70 degrees a second: 1 s
  ok    turns for its minimum time and until the way is free, but for at most 6 s: 7 s
  ok    makes each turn longer than the one before, and starts again after the fifth: 1 s
  ok    backs up after each bump, and turns away for longer than the last time: 9 s
  ok    follows the ball and touches nothing: 1 seed, 45 s
  ok    keeps a metre away from the ball and never loses sight of it: 2 seeds, 45 s
  ok    reaches its speed within 3 s, and says so: 4 s
  ok    drives squares for four minutes, at the same place: 5 seeds, 240 s
  ok    holds its course and touches nothing: 10 seeds, 25 s
  ok    stops half a metre before the wall: 10 seeds, 25 s
  ok    turns by 2 rad/s for each radian off course, and by 0.3 rad/s more for each second of that: 3 s
  ok    turns less while the error shrinks, by a tenth of how fast it does: 2 s
  ok    turns no faster than 60 degrees a second: 1 s
  ok    stands half a metre before an obstacle, and is 0.5 m/s faster for each metre more: 1 s
  ok    speeds up and brakes by 0.3 m/s each second: 4 s
  skip  reaches the lamp in time and touches nothing: needs the robot Moth, whose body is written in C
  skip  ends at the lamp: needs the robot Moth, whose body is written in C
  ok    follows the tape for 12 m: 2 seeds, 60 s
  ok    follows the tape three times round: 3 seeds, 220 s
  ok    stays within 4 cm of the tape on the straight stretch: 3 seeds, 220 s
  ok    finds the line again behind a corner, and stops at its end: 3 seeds, 40 s
  ok    drives at 0.25 m/s in the middle, and at 0.1 m/s with the line on one side: 1 s
  ok    turns to the line, by 60 degrees a second if one sensor is on it and the other is not: 1 s
  ok    takes a line for lost if it was not seen for 0.2 s, and remembers the side: 2 s
  ok    takes anything darker than 0.7 for the line, on either side: 1 s
  ok    searches 120 degrees to one side, then as far to the other: 7 s
  ok    ends its search when it finds the line, on either side: 6 s
  ok    drives ahead to the line, and gives up if there is none in 20 s: 21 s
  ok    drives back and forth and touches nothing: 3 seeds, 180 s
  ok    reaches each end once a minute: 3 seeds, 180 s
  ok    makes a full turn to the left in six seconds: 7 s
  ok    follows the obstacle on its left for eight seconds, 0.3 m away: 9 s
  ok    looks round at each end, and drives back: 55 s
  ok    drives on to the same place after it has gone round an obstacle: 40 s
  ok    drives on for three minutes and touches nothing: 3 seeds, 180 s
  ok    gets half a metre away from every place within a minute: 3 seeds, 180 s
  ok    cruises at 0.3 m/s if nothing is near, and turns both ways: 20 s
  ok    steers away from an object at a side, by 4 rad/s for each metre: 1 s
  ok    dodges to the side with more room, and does not change the side: 2 s
  ok    does not dodge an obstacle that is near for one instant only: 2 s
  ok    dodges for at least half a second: 2 s
  ok    an escape wins over everything else and lasts for 1.5 s: 3 s
  ok    turns away from the side that was hit: 1 s
  ok    commands what the layers decide: 1 s
  ok    drives up to the poster: 2 seeds, 16 s
  ok    gets there and back, and touches nothing: 3 seeds, 90 s
  ok    an object 0.75 m away blocks 32 degrees on each side: 1 s
  ok    an object beyond the horizon blocks nothing, and a very close one a half turn: 1 s
  ok    an unknown direction is blocked: 1 s
  ok    takes the free direction nearest to the goal, and stays on the side that it chose: 1 s
  ok    drives towards a goal, past an object, and stands still without scans: 2 s
  ok    turns on the spot if everything is near: 1 s
  ok    drives round the room, 0.2 m from the wall, and touches nothing: 10 seeds, 60 s
  ok    limits a number on both sides: 1 s
  ok    approaches its distance by 1.2 of the difference each second: 3 s
  ok    turns by 8 rad/s for each m/s by which the distance changes too slowly: 1 s
  ok    approaches the wall at no more than 50 degrees: 1 s
  ok    slows down before an obstacle, and backs away if it is too near: 1 s
  93 tests: all hold; 3 skipped
  $ for robot in pioneer scout create; do
  >   for name in bug corridor dock explore patrol subsumption vfh; do
  >     frobc test $examples/$name/$name.frob --robot $robot --seeds 2 | tail -1
  >   done
  > done
  8 tests: all hold
  8 tests: all hold
  11 tests: all hold
  10 tests: all hold
  6 tests: all hold
  10 tests: all hold
  7 tests: all hold
  8 tests: all hold
  8 tests: all hold
  11 tests: all hold
  10 tests: all hold
  6 tests: all hold
  10 tests: all hold
  7 tests: all hold
  8 tests: all hold
  8 tests: all hold
  11 tests: all hold
  10 tests: all hold
  6 tests: all hold
  10 tests: all hold
  7 tests: all hold

Examples that need C run if their files are given, as the message says.

  $ frobc test $examples/light_seek $examples/blob_tracker | sed -n 's/^      //p' | sort -u > commands
  error: no test was run; see above for how to run the skipped tests
  $ sed "s|$examples/||g" commands
  frobc test blob_tracker/blob_tracker.frob --with blob_tracker/blob.c
  frobc test light_seek/light_seek.frob --robot light_seek/Moth.frob --with light_seek/moth_body.c
  $ sh commands
  ok    finds the same blob with both trackers: 4 s
  1 test: all hold
  ok    reaches the lamp in time and touches nothing: 10 seeds, 60 s
  ok    ends at the lamp: 10 seeds, 60 s
  2 tests: all hold
  $ frobc test $examples/light_seek > /dev/null
  error: no test was run; see above for how to run the skipped tests
  [2]
  $ frobc test $examples/light_seek $examples/from_c --junit left.xml --json | grep -o '"skipped".*'
  "skipped":"needs the robot Moth, whose body is written in C","command":"frobc test ../../../examples/light_seek/light_seek.frob --robot ../../../examples/light_seek/Moth.frob --with ../../../examples/light_seek/moth_body.c"}
  "skipped":"needs the robot Moth, whose body is written in C","command":"frobc test ../../../examples/light_seek/light_seek.frob --robot ../../../examples/light_seek/Moth.frob --with ../../../examples/light_seek/moth_body.c"}
  $ grep -c skipped left.xml
  3

If a file is named, its tests must run.

  $ frobc test $examples/blob_tracker/blob_tracker.frob
  FAIL  finds the same blob with both trackers: cannot be run
  1 test: 1 failed
  error: the program includes the C header `../../../examples/blob_tracker/blob.h`, which the command line does not allow: C code can do anything on your computer; if you trust it, add `--with ../../../examples/blob_tracker/blob.h` (or name a C file that includes it); the program also calls `blob`, `blob_brighter`, `blob_measure` and 1 more, whose C files are missing too
  [1]
