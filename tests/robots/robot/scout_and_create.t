The same wall follower drives a Scout and a Create behind their lines: along the
wall and round the corner, without touching it.

  $ . ./robot.sh
  $ . ../run/within.sh
  $ follow () {
  >   start_robot --world wall.toml
  >   frobc run ../../../../examples/wall_follow/wall_follow.frob --robot $kind --device ./line --for 15s --record log.csv > summary
  >   end_robot
  > }
  $ for kind in scout create; do
  >   (mkdir $kind; cd $kind; cp ../*.toml .; in_time follow) &
  > done
  $ wait
  $ within distance_driven 3 5.5 mean_wall_distance_error 0 0.05 largest_wall_distance_error 0 0.2 odometry_error_at_the_end 0 0.1 collisions 0 0 < scout/served
  $ within distance_driven 3.5 6 mean_wall_distance_error 0 0.05 largest_wall_distance_error 0 0.2 odometry_error_at_the_end 0 0.1 collisions 0 0 < create/served
  $ head -1 scout/summary create/summary | grep robot:
  robot: Nomadic Scout
  robot: iRobot Create 2
  $ for robot in scout create; do within connections 1 1 < $robot/summary; awk -F, '$4 < -1.2 { round = 1 } END { print round }' $robot/log.csv; done
  1
  1

The recordings replay, bit for bit.

  $ for robot in scout create; do
  >   frobc trace ../../../examples/wall_follow/wall_follow.frob --robot $robot --input $robot/log.csv --output again.csv
  >   columns=$(head -1 again.csv | tr ',' '\n' | wc -l)
  >   awk -F, -v n=$columns '{ line = $1; for (i = NF - n + 2; i <= NF; i++) line = line "," $i; print line }' $robot/log.csv | cmp - again.csv
  > done

A Create at a hole leaves the mode in which it drives. That ends the run; the driver does not
restore the mode.

  $ kind=create; start_robot --world hole.toml
  $ frobc run forward.frob --robot create --device ./line --for 20s > summary
  error: cannot drive the robot: iRobot Create 2, which left driving mode because of a cliff, a wheel drop or a charger; sent a stop command to the robot
  [4]
  $ until_true 'tail -1 told | grep -q START'
  $ end_robot
  $ within distance_driven 0.75 0.95 collisions 0 0 < served
  $ grep -c SAFE told
  1

When the program's process is killed, both robots receive a stop.

  $ for kind in scout create; do
  >   start_robot
  >   frobc build forward.frob --robot $kind -o forward
  >   ./forward --device ./line --for 60 > summary 2> messages &
  >   run=$!
  >   until_true 'grep -q "VM 118 118\|DRIVE_DIRECT 300 300" told'
  >   set -- $(cat /proc/$run/task/$run/children)
  >   kill -KILL $1
  >   wait $run; echo "status $?"
  >   until_true 'tail -n 3 told | grep -q "ST$\|DRIVE_DIRECT 0 0"'
  >   end_robot
  > done
  status 4
  status 4

So does a Create, which has no watchdog, when the process that owns its line is killed; and a Scout,
which has one.

  $ for kind in scout create; do
  >   start_robot
  >   frobc build forward.frob --robot $kind -o forward
  >   ./forward --device ./line --for 60 > summary 2> messages &
  >   run=$!
  >   until_true 'grep -q "VM 118 118\|DRIVE_DIRECT 300 300" told'
  >   kill -KILL $run
  >   wait $run 2> /dev/null
  >   until_true 'tail -n 3 told | grep -q "ST$\|DRIVE_DIRECT 0 0"'
  >   end_robot
  > done

The cable is pulled and plugged in again: the run continues, starting with a
speed of zero. Meanwhile the Create drives on; the Scout's watchdog stops it
after a second.

  $ for kind in scout create; do
  >   start_robot
  >   frobc build forward.frob --robot $kind -o forward
  >   ./forward --device ./line --for 60 --progress > summary 2> messages &
  >   run=$!
  >   until_true 'grep -q "VM 118 118\|DRIVE_DIRECT 300 300" told'
  >   kill -USR1 $robot; until_true 'grep -q lost messages'
  >   [ $kind = create ] || until_true 'grep -q watchdog told'
  >   mark; kill -USR2 $robot; until_true '[ -e line ]'
  >   until_true 'told "VM 118 118\|DRIVE_DIRECT 300 300"'
  >   tail -n +$((marked + 1)) told | awk '{ sub(/^[0-9.]* /, "") } /^(VM|ST$|DRIVE)/ { print; exit }'
  >   kill -INT $run; wait $run
  >   grep connections summary
  >   end_robot
  > done
  ST
  connections: 2
  DRIVE_DIRECT 0 0
  connections: 2

A robot that does not answer may be turned off, on another line, or require another rate: the
message names the rate that was tried. If bytes arrive on the line, the cable is not the problem.

  $ kind=scout; start_robot; kill -STOP $robot
  $ frobc run forward.frob --robot scout --device ./line --for 1s > summary
  error: no scout answers on ./line at 38400 baud: turn it on, plug in its cable, and check the line and its rate (`--set baud=...`); sent a stop command to the robot
  [4]
  $ frobc run forward.frob --robot create --device ./line --for 1s --set baud=57600 > summary
  error: no create answers on ./line at 57600 baud: turn it on, plug in its cable, and check the line and its rate (`--set baud=...`); sent a stop command to the robot
  [4]
  $ kill -CONT $robot; end_robot
  $ kind=pioneer; start_robot; start_driving
  $ kill -KILL $run $controller $guard $second_guard
  $ frobc run forward.frob --robot create --device ./line --for 1s > summary
  error: a device sends data on ./line, but no create answers at 115200 baud: check the line and its rate (`--set baud=...`); sent a stop command to the robot
  [4]
  $ end_robot
