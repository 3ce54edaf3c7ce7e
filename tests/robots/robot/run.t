A program runs on the robot behind a serial line as in the simulator; the
summary reports the run.

  $ . ./robot.sh
  $ drive () { # TIME [OPTION OF THE ROBOT...]
  >   time=$1
  >   shift
  >   start_robot "$@"
  >   frobc run drive.frob --device ./line --for $time --record log.csv > summary
  >   until_true 'tail -1 told | grep -q CLOSE'
  >   end_robot
  > }
  $ in_time drive 2s
  $ sed 's/: [0-9.]*\( m\{0,1\}s\)$/: N\1/; s/^steps: .*/steps: N/; s/^\(overruns\|late steps\|stale readings\): [0-9]*/\1: N/' summary
  robot: Pioneer p3dx-sh, FrobSim
  time run: N s
  steps: N
  overruns: N
  late steps: N
  longest step: N ms
  stale readings: N
  connections: 1
  log: log.csv

After the handshake (whose SYNCs have the numbers of PULSE, OPEN and CLOSE), the robot receives zero
speeds before anything else, and finally a stop.

  $ awk '{ print $2, $3 }' told | sed -n '5,6p'
  VEL 0
  RVEL 0
  $ awk '{ print $2, $3 }' told | tail -4
  VEL 0
  RVEL 0
  STOP 
  CLOSE 

It drove as far as the program commanded, according to odometry.

  $ awk '/^distance driven/ { print ($3 > 0.3 && $3 < 0.75) }' served
  1
  $ awk -F, 'END { print ($2 > 0.2 && $2 < 0.65) }' log.csv
  1

The recording contains the measured times, so a replay has the same commands,
bit for bit.

  $ frobc trace drive.frob --input log.csv --output again.csv
  $ sed 's/,.*,\([^,]*,[^,]*\)$/,\1/' log.csv | cmp - again.csv

`frobc build` builds the executable that was run; it also accepts TCP.

  $ frobc build drive.frob --robot pioneer -o drive
  $ rm served
  $ frobc serve --robot pioneer --world hall.toml --for 600s --tcp 0 > served &
  $ robot=$!
  $ until_true 'grep -q device served 2> /dev/null'
  $ ./drive --device "$(sed 's/device: //' served)" --for 0.2 | head -1
  robot: Pioneer p3dx-sh, FrobSim
  $ end_robot

Other models have other conversion factors.

  $ in_time drive 1500ms --model p3dx
  $ head -1 summary
  robot: Pioneer p3dx, FrobSim
  $ awk '/^distance driven/ { print ($3 > 0.1) }' served
  1
  $ awk -F, 'END { print ($2 > 0.1 && $2 < 0.5) }' log.csv
  1

A task that ends leaves the robot at rest; the summary shows its result.

  $ finish () {
  >   start_robot
  >   frobc run task.frob --device ./line --exit-when-done --for 10s --record log.csv > summary
  >   end_robot
  > }
  $ in_time finish
  $ sed -n 's/finished after: 0.5.*/finished after: 0.5/p; /^result/p' summary
  finished after: 0.5
  result: true
  $ frobc trace task.frob --input log.csv --output again.csv
  $ tail -1 again.csv | cut -d, -f 2-
  0,0,true

Real-time priority and locked memory require permission; without it, a warning
says how to get it, and the run continues.

  $ start_robot
  $ without_rights () {
  >   if [ "$(id -u)" = 0 ]; then set -- setpriv --bounding-set -sys_nice,-ipc_lock,-sys_resource "$@"; fi
  >   prlimit --rtprio=0 --memlock=65536 "$@"
  > }
  $ without_rights ./drive --device ./line --for 0.2 --priority 50 --lock-memory 2>&1 > summary | sed 's/: [^:;]*;/: REASON;/'
  warning: cannot set real-time priority 50: REASON; the run continues without it. Run the program as root, or add a line `YOU - rtprio 50` to /etc/security/limits.conf
  warning: cannot lock memory: REASON; the run continues with unlocked memory. Run the program as root, or add a line `YOU - memlock unlimited` to /etc/security/limits.conf
  $ grep -c "connections: 1" summary
  1
  $ end_robot

The parent process may close the standard streams: the line and the controller never get their
descriptors, to which text would be printed.

  $ start_robot
  $ ./drive --device ./line --for 0.3 --progress 2>&- | sed -n '/connections/p'
  connections: 1
  $ ./drive --device ./line --for 0.3 --progress --console <&- >&- 2>&-
  [2]
  $ ./drive --device ./line --for 0.3 > /dev/full
  error: cannot write to standard output: No space left on device
  [2]
  $ end_robot

A recording that cannot be written ends the run, with the robot stopped; so does one that exceeds
the file size limit, which does not raise a signal.

  $ start_robot
  $ (ulimit -f 4; ./drive --device ./line --for 30 --record log.csv > summary)
  error: cannot write log.csv: File too large
  error: the recording could not be written; sent a stop command to the robot
  [4]
  $ until_stopped
  last speed: 0
  $ end_robot
