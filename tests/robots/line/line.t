BUG and the wall follower, through the drivers and the lines of all robots, in
virtual time: they reach what they reach in the simulator, and touch nothing. The
line follower does on the robot that sees the floor.

  $ sh ./seeds.sh frobc ./frob-line ../../../examples 3
  bug on a pioneer behind its line: 0 runs out of bounds
  bug on a scout behind its line: 0 runs out of bounds
  bug on a create behind its line: 0 runs out of bounds
  wall_follow on a pioneer behind its line: 0 runs out of bounds
  wall_follow on a scout behind its line: 0 runs out of bounds
  wall_follow on a create behind its line: 0 runs out of bounds
  line_follow on a create behind its line: 0 runs out of bounds
