The cable is pulled and plugged in again, and the device then has another name:
the run continues, starting with a speed of zero. The robot's own watchdog is
not involved, because the robot would resume its old speed. At most two seconds
after the robot's return, it drives again.

  $ . ./robot.sh
  $ now () { awk -v slow=$FROB_SLOW '{ print $1 / slow }' /proc/uptime; } # by the robot's clock
  $ drives_again () { tail -n +$((marked + 1)) told | awk -v plugged=$plugged '$2 == "VEL" && $3 == 300 { print $1 - plugged < 2 ? "within two seconds" : $1 - plugged; exit }'; }
  $ replug () {
  >   start_robot
  >   start_driving
  >   kill -USR1 $robot; until_true 'grep -q lost messages'
  >   mark; plugged=$(now)
  >   kill -USR2 $robot; until_true 'told "VEL 300"'
  >   tail -n +$((marked + 1)) told | awk '$2 == "VEL" { print $3; exit }'
  >   drives_again
  >   kill -INT $run; wait $run; echo "status $?"
  >   end_robot
  > }
  $ in_time replug
  0
  within two seconds
  status 4
  $ sed 's/at [0-9.]* s/at N s/' messages
  connected: Pioneer p3dx-sh, FrobSim
  lost the connection to the robot: its line was disconnected
  connected: Pioneer p3dx-sh, FrobSim
  interrupted at N s: the summary covers the run until then; run the same command again to start over
  error: the run was ended by an interrupt; sent a stop command to the robot
  $ grep connections summary
  connections: 2

However often this happens, no descriptor stays open.

  $ start_robot
  $ start_driving
  $ open_files () { ls /proc/$run/fd | wc -l; }
  $ files=$(open_files)
  $ for i in 1 2 3 4 5; do
  >   kill -USR1 $robot; until_true '[ $(grep -c lost messages) = $i ]'
  >   kill -USR2 $robot; until_true '[ $(grep -c ^connected messages) = $((i + 1)) ]'
  > done
  $ [ $(open_files) = $files ]
  $ wc -w < /proc/$run/task/$run/children
  3
  $ kill -INT $run; wait $run
  [4]

The same with a robot on the network, whose server disappears and returns.

  $ end_robot
  $ serve_on () {
  >   rm -f served; frobc serve --robot pioneer --world hall.toml --for 600s --tcp $1 --log told > served &
  >   robot=$!; until_true 'grep -q device served 2> /dev/null'
  > }
  $ serve_again () {
  >   serve_on 0; port=$(sed 's/.*://' served)
  >   : > told; ./drive --device tcp:127.0.0.1:$port --for 60 --progress > summary 2> messages & run=$!
  >   until_true 'grep -q "VEL 300" told'
  >   end_robot > /dev/null; until_true 'grep -q lost messages'
  >   mark; serve_on $port; plugged=$(now)
  >   until_true 'told "VEL 300"'
  >   drives_again
  >   kill -INT $run; wait $run; echo "status $?"
  >   end_robot > /dev/null
  > }
  $ in_time serve_again
  within two seconds
  status 4
  $ start_robot

A robot that does not return ends the run.

  $ start_driving --reconnect 0.3
  $ kill -USR1 $robot; wait $run
  [4]
  $ tail -1 messages
  error: lost the connection to the robot, and could not reconnect within 0.3 s; the robot could not be reached to stop it
  $ end_robot

A robot that is turned off does not answer; at the first connection this is an
error.

  $ start_robot
  $ kill -STOP $robot
  $ frobc run drive.frob --for 1s --device ./line --set baud=9600 > /dev/null
  error: no pioneer answers on ./line at 9600 baud: turn it on, plug in its cable, and check the line and its rate (`--set baud=...`); sent a stop command to the robot
  [4]
  $ kill -CONT $robot
  $ end_robot
