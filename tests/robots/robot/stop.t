Whatever ends or stops any part of a run, the robot is told to stop.

  $ . ./robot.sh
  $ start_robot

An interrupt, and SIGTERM:

  $ start_driving; mark; kill -INT $run; wait $run
  [4]
  $ until_stopped; cat messages
  last speed: 0
  connected: Pioneer p3dx-sh, FrobSim
  error: the run was ended by an interrupt; the robot was told to stop
  $ start_driving; mark; kill -TERM $run; wait $run
  [4]
  $ until_stopped; tail -1 messages
  last speed: 0
  error: the run was ended by Terminated; the robot was told to stop

The controller is killed:

  $ start_driving; mark; kill -KILL $controller; wait $run
  [4]
  $ until_stopped; tail -1 messages
  last speed: 0
  error: the controller was ended by signal 9 (Killed); the robot was told to stop

The controller stops, as in an endless loop: the robot is stopped after 0.2 s,
and the run is given up after two seconds.

  $ start_driving; mark; kill -STOP $controller; wait $run
  [4]
  $ until_stopped; tail -2 messages
  last speed: 0
  a step takes longer than 0.2 s: the robot is stopped
  error: the controller has not finished a step for 2 s; the robot was told to stop

When it goes on in time, so does the robot.

  $ start_driving; mark; kill -STOP $controller
  $ until_stopped
  last speed: 0
  $ mark; kill -CONT $controller; until_true 'told "VEL 300"'
  $ kill -INT $run; wait $run
  [4]
  $ awk '/^late steps/ { print ($3 >= 1) }' summary
  1

The process that holds the line is killed: the guard stops the robot, before
the robot's own watchdog does.

  $ start_driving; mark; kill -KILL $run; wait $run 2> /dev/null
  [137]
  $ until_stopped; told watchdog
  last speed: 0
  [1]
  $ until_true '! [ -e /proc/$guard ] && ! [ -e /proc/$controller ]'

A run that is killed loses no row of its recording, and the rows replay.

  $ start_driving --record log.csv; sleep 0.3; kill -KILL $run; wait $run 2> /dev/null
  [137]
  $ awk -F, 'NR == 1 { columns = NF } NF != columns { print "row", NR } END { print (NR > 10) }' log.csv
  1
  $ frobc trace drive.frob --input log.csv --output again.csv
  $ sed 's/,.*,\([^,]*,[^,]*\)$/,\1/' log.csv | cmp - again.csv
  $ until_true '! [ -e /proc/$guard ]'

It is stopped with SIGSTOP: the guard stops the robot until it goes on.

  $ start_driving; mark; kill -STOP $run
  $ until_stopped; told watchdog
  last speed: 0
  [1]
  $ mark; kill -CONT $run; until_true 'told "VEL 300"'
  $ kill -INT $run; wait $run
  [4]

The guard is killed: the run goes on.

  $ start_driving; mark; kill -KILL $guard
  $ mark; until_true 'told "VEL 300"'; kill -INT $run; wait $run
  [4]
  $ until_stopped
  last speed: 0
  $ end_robot
