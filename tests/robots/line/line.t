BUG and the wall follower drive all robots through their drivers and lines, in virtual time: they
reach the same goals as in the simulator, and touch nothing. The line follower does so on the robot
that senses the floor.

  $ sh ./seeds.sh frobc ./frob-line ../../../examples 3
  bug on a pioneer behind its line: 0 runs out of bounds
  bug on a scout behind its line: 0 runs out of bounds
  bug on a create behind its line: 0 runs out of bounds
  wall_follow on a pioneer behind its line: 0 runs out of bounds
  wall_follow on a scout behind its line: 0 runs out of bounds
  wall_follow on a create behind its line: 0 runs out of bounds
  line_follow on a create behind its line: 0 runs out of bounds
