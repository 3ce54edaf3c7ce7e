The cable is pulled and plugged in again, and the device has another name then:
the run goes on, with zero first. The robot's own watchdog is not what stops it
here, it would take up its old speed.

  $ . ./robot.sh
  $ start_robot
  $ start_driving
  $ before=$(readlink line)
  $ kill -USR1 $robot; until_true 'grep -q lost messages'
  $ mark; plugged=$(awk '{ print $1 }' /proc/uptime)
  $ kill -USR2 $robot; until_true 'told "VEL 300"'
  $ tail -n +$((marked + 1)) told | awk '$2 == "VEL" { print $3; exit }'
  0

Two seconds after its return it drives again, at the latest.

  $ tail -n +$((marked + 1)) told | awk -v plugged=$plugged '$2 == "VEL" && $3 == 300 { print ($1 - plugged < 2); exit }'
  1
  $ kill -INT $run; wait $run
  [4]
  $ cat messages
  connected: Pioneer p3dx-sh, FrobSim
  the robot is lost: its line is gone
  connected: Pioneer p3dx-sh, FrobSim
  error: the run was ended by an interrupt; the robot was told to stop
  $ grep connections summary
  connections: 2

However often that happens, nothing is left open.

  $ start_driving
  $ open_files () { ls /proc/$run/fd | wc -l; }
  $ files=$(open_files)
  $ for i in 1 2 3 4 5; do
  >   kill -USR1 $robot; until_true '[ $(grep -c lost messages) = $i ]'
  >   kill -USR2 $robot; until_true '[ $(grep -c connected messages) = $((i + 1)) ]'
  > done
  $ [ $(open_files) = $files ]
  $ wc -w < /proc/$run/task/$run/children
  2
  $ kill -INT $run; wait $run
  [4]

So it is with one on the network, whose server goes and comes again.

  $ end_robot
  $ serve_on () {
  >   rm -f served; frobc serve --robot pioneer --world hall.toml --for 60s --tcp $1 --log told > served &
  >   robot=$!; until_true 'grep -q device served 2> /dev/null'
  > }
  $ serve_on 0; port=$(sed 's/.*://' served)
  $ : > told; ./drive --device tcp:127.0.0.1:$port --for 60 --progress > summary 2> messages &
  $ run=$!; until_true 'grep -q "VEL 300" told'
  $ end_robot > /dev/null; until_true 'grep -q lost messages'
  $ mark; serve_on $port; plugged=$(awk '{ print $1 }' /proc/uptime)
  $ until_true 'told "VEL 300"'
  $ tail -n +$((marked + 1)) told | awk -v plugged=$plugged '$2 == "VEL" && $3 == 300 { print ($1 - plugged < 2); exit }'
  1
  $ kill -INT $run; wait $run
  [4]
  $ end_robot > /dev/null; start_robot

A robot that does not come back ends the run.

  $ start_driving --reconnect 0.3
  $ kill -USR1 $robot; wait $run
  [4]
  $ tail -1 messages
  error: the robot was lost, and did not come back within 0.3 s; the robot was not reached to be stopped
  $ end_robot

One that was turned off does not answer; the first time that is an error.

  $ start_robot
  $ kill -STOP $robot
  $ frobc run drive.frob --for 1s --device ./line --set baud=9600 > /dev/null
  error: no pioneer answers on ./line at 9600 baud: is it turned on, is its cable plugged in, and are this its line and its rate (`--set baud=...`)?; the robot was told to stop
  [4]
  $ kill -CONT $robot
  $ end_robot
