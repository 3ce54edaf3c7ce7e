Whatever ends or stops any part of a run, the robot receives a stop.

  $ . ./robot.sh
  $ start_robot

SIGINT and SIGTERM:

  $ start_driving; mark; kill -INT $run; wait $run
  [4]
  $ until_stopped; grep -m 1 ^connected messages; tail -1 messages
  last speed: 0
  connected: Pioneer p3dx-sh, FrobSim
  error: the run was ended by an interrupt; sent a stop command to the robot
  $ start_driving; mark; kill -TERM $run; wait $run
  [4]
  $ until_stopped; tail -1 messages
  last speed: 0
  error: the run was ended by Terminated; sent a stop command to the robot

After Ctrl-C, the output says what was saved and how to continue, before it
reports on the robot.

  $ start_driving --record log.csv; kill -INT $run; wait $run
  [4]
  $ tail -2 messages | sed 's/at [0-9.]* s/at N s/'
  interrupted at N s: the summary covers the run until then, and so does log.csv; run the same command again to start over and overwrite that file
  error: the run was ended by an interrupt; sent a stop command to the robot
  $ at=$(sed -n 's/^interrupted at \([0-9.]*\) s.*/\1/p' messages)
  $ grep -q "^time run: $at s" summary

The controller is killed:

  $ start_driving; mark; kill -KILL $controller; wait $run
  [4]
  $ until_stopped; tail -1 messages
  last speed: 0
  error: the controller was killed by signal 9 (Killed); sent a stop command to the robot

The controller hangs, as in an endless loop: the robot is stopped after 0.2 s,
and the run is given up after two seconds.

  $ start_driving; mark; kill -STOP $controller; wait $run
  [4]
  $ until_stopped; grep 'a step' messages | tail -2
  last speed: 0
  a step takes longer than 0.2 s: stopping the robot
  error: the controller has not finished a step for 2 s; sent a stop command to the robot

If the controller continues in time, so does the robot.

  $ start_driving; mark; kill -STOP $controller
  $ until_stopped
  last speed: 0
  $ mark; kill -CONT $controller; until_true 'told "VEL 300"'
  $ kill -INT $run; wait $run
  [4]
  $ awk '/^late steps/ { print ($3 >= 1) }' summary
  1

The process that owns the line is killed: the guard stops the robot, before the
robot's own watchdog does.

  $ start_driving; mark; kill -KILL $run; wait $run 2> /dev/null
  [137]
  $ until_stopped; told watchdog
  last speed: 0
  [1]
  $ until_true '! [ -e /proc/$guard ] && ! [ -e /proc/$second_guard ] && ! [ -e /proc/$controller ]'

A killed run loses no row of its recording, and the rows can be replayed.

  $ start_driving --record log.csv; sleep 0.3; kill -KILL $run; wait $run 2> /dev/null
  [137]
  $ awk -F, 'NR == 1 { columns = NF } NF != columns { print "row", NR } END { print (NR > 10) }' log.csv
  1
  $ frobc trace drive.frob --input log.csv --output again.csv
  $ sed 's/,.*,\([^,]*,[^,]*\)$/,\1/' log.csv | cmp - again.csv
  $ until_true '! [ -e /proc/$guard ] && ! [ -e /proc/$second_guard ]'

The process is stopped with SIGSTOP: the guard stops the robot until the process
continues.

  $ start_driving; mark; kill -STOP $run
  $ until_stopped; told watchdog
  last speed: 0
  [1]
  $ mark; kill -CONT $run; until_true 'told "VEL 300"'
  $ kill -INT $run; wait $run
  [4]

All processes of the run are stopped, as by a debugger or a machine that sleeps. When they continue,
the readings on the line are old. The first speed that the robot receives is zero, and the run
continues.

  $ start_driving
  $ for time in 0.3 0.4 0.5 0.6 0.7 0.8 0.9 2; do
  >   kill -STOP $run $controller $guard $second_guard; sleep $time; mark
  >   kill -CONT $second_guard $guard $controller $run; until_true 'told "VEL 300"'
  >   tail -n +$((marked + 1)) told | awk '$2 == "VEL" { print $2, $3; exit }'
  > done
  VEL 0
  VEL 0
  VEL 0
  VEL 0
  VEL 0
  VEL 0
  VEL 0
  VEL 0
  $ kill -INT $run; wait $run
  [4]

A guard is killed, or hangs: the run continues, reports it, and starts another guard, which can stop
the robot. There are two guards, so that one of them may be killed together with the process that
owns the line.

  $ start_driving; kill -KILL $guard; kill -STOP $second_guard
  $ until_true 'grep -q signal messages && grep -q hangs messages'; grep guard messages
  warning: a guard process was killed by signal 9 (Killed); starting another one
  warning: a guard process hangs; starting another one
  $ ! [ -e /proc/$guard ] && ! [ -e /proc/$second_guard ]
  $ mark; until_true 'told "VEL 300"'
  $ set -- $(cat /proc/$run/task/$run/children); guard=$2 second_guard=$3
  $ mark; kill -KILL $run $guard; wait $run 2> /dev/null
  [137]
  $ until_stopped; told watchdog
  last speed: 0
  [1]
  $ until_true '! [ -e /proc/$second_guard ] && ! [ -e /proc/$controller ]'
  $ end_robot
