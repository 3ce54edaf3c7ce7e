What the examples promise of themselves holds, on each robot that they are for.

  $ examples=../../../examples
  $ frobc test $examples | grep -v '^      '
  ok    gets to the goal, past all that is in the way: 3 seeds, 240 s
  ok    drives to the end of the corridor: 10 seeds, 35 s
  ok    keeps to the middle, to the end: 3 seeds, 28 s
  ok    drives into the dock: 10 seeds, 40 s
  ok    docks within 2 cm and 2 degrees: 20 seeds, 35 s
  ok    goes on and on: 3 seeds, 300 s
  ok    keeps a metre behind the ball, and touches nothing: 2 seeds, 45 s
  ok    holds its course, and stops before the wall: 10 seeds, 25 s
  ok    follows the tape round: 2 seeds, 60 s
  ok    follows the tape three times round: 3 seeds, 220 s
  ok    goes to and fro and touches nothing: 3 seeds, 180 s
  ok    drives up to the poster: 2 seeds, 16 s
  ok    goes round the room and touches nothing: 10 seeds, 60 s
  13 tests: all hold
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
