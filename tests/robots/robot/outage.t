The robot is unreachable for 4 s: its server is killed and restarted, or stopped
with SIGSTOP. The program has one instant whose step is the outage, and `outage`
returns its length. The first speed on the line afterwards is zero. A rate limit
and a PID count at most 0.2 s, a low-pass the whole time.

  $ . ./robot.sh
  $ cat > drives.frob <<FROB
  > import Control
  > import Robot
  > main :: DiffDrive o => Program i o
  > main = reactimateRobot (proc _ -> roMake (setVelTR v 0) where
  >     v = rateLimit 0.25[m/s^2] (if time () < 0.05[s] then 0 else 0.3[m/s])
  >     _away = outage ()
  >     _total = pid gains 1[m/s]
  >     _smooth = lowPass 0.5[s] v)
  > gains :: Pid[m/s, m]
  > gains = Pid { kp = 0, ki = 1, kd = 0, largest = 100[m] }
  > FROB
  $ frobc build drives.frob --robot pioneer -o drives
  $ drive_on () {
  >   ./drives --device ./line --for 60 --progress --record log.csv > summary 2> messages & run=$!
  >   until_true 'grep -q "VEL 300" told'
  > }

The first speed that is sent after the outage, and then the program's state at its longest outage.
On a busy machine there may be other, short outages.

  $ judge () {
  >   until_true 'told "VEL 300"'
  >   tail -n +$((marked + 1)) told | awk '$2 == "VEL" { print $2, $3; exit }'
  >   kill -INT $run; wait $run
  >   frobc trace drives.frob --robot pioneer --input log.csv --probe v --probe _away --probe _total --probe _smooth > seen.csv
  >   awk -F, 'function far(a, b) { return a > b ? a - b : b - a }
  >     NR > 2 && far($4, v) > 0.0501 { print "the rate limit jumps at", $1 }
  >     NR > 2 && far($6, total) > 0.2001 { print "the PID jumps at", $1 }
  >     NR > 1 { v = $4; total = $6 }
  >     $5 + 0 > longest { longest = $5; smooth = far($7, $4) < 0.01; step = $1 - before }
  >     { before = $1 }
  >     END { print (longest > 3.5 ? "away" : "not away: " longest),
  >           (far(longest, step) < 1e-6 ? "for the whole step" : step),
  >           (smooth ? "and the low-pass has forgotten" : "and the low-pass remembers") }' seen.csv
  > }

A server that is killed, and restarted after 4 s. Its terminal's name is then free, and another
process may get it, so the link to it must be removed, too.

  $ start_robot; drive_on
  $ kill -KILL $robot; rm line; wait $robot 2> /dev/null
  [137]
  $ sleep 4; start_robot; marked=0; judge
  VEL 0
  away for the whole step and the low-pass has forgotten

A server that is stopped for 4 s. The bytes that the host wrote meanwhile wait on the line, and are
a stop command.

  $ : > told; drive_on
  $ mark; kill -STOP $robot; sleep 4; kill -CONT $robot; judge
  VEL 0
  away for the whole step and the low-pass has forgotten
  $ end_robot
