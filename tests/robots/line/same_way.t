A program drives the same path in the simulator as on the robot behind its line: the simulator
rounds speeds like the protocol. Each robot turns at 0.008 rad/s, below the resolution of its
protocol, for 8 s; then it drives an S, and stops. Both runs are judged by the robot's true
position; in the simulator this is its odometry, which here has no errors except the resolution of a
Create's encoders.

  $ cat > slow.frob <<EOF
  > import Robot
  > 
  > main :: (HasOdometry i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc _ -> roMake (setVelTR v omega) where
  >     t = time ()
  >     v = if t < 8[s] || t > 20[s] then 0 else 0.0873[m/s]
  >     omega = if t < 8[s] then 0.008[rad/s] else if t > 20[s] then 0 else 0.3[rad/s] * cos (t * 0.5[rad/s]))
  > EOF
  $ cat > hall.toml <<EOF
  > [start]
  > x = 0
  > y = 0
  > EOF
  $ differs () { awk -v robot="$1" -v x="$2" -v y="$3" -v heading="$4" '
  >   { dx = $8 - x; dy = $9 - y; d = sqrt(dx * dx + dy * dy); a = $10 - heading; if (a < 0) a = -a
  >     printf "%s: %s, %s\n", robot, d < 0.005 ? "same place" : "places " d " m apart",
  >       a < 0.005 ? "same heading" : "headings " a " rad apart" }'; }
  $ for robot in pioneer scout create; do
  >   for seconds in 8 21; do
  >     frobc run slow.frob --robot $robot --world hall.toml --for ${seconds}s --record $robot.csv > told || cat told
  >     XDG_CACHE_HOME=$PWD/$robot frobc run slow.frob --robot $robot --world hall.toml --for 10ms > told || cat told
  >     ./frob-line $robot/frobc/*.so $robot hall.toml 1 $seconds log=$robot.log > told || cat told
  >     tail -1 $robot.log | differs $robot $(tail -1 $robot.csv | cut -d, -f2-4 | tr , ' ')
  >     [ $seconds = 21 ] || tail -1 $robot.log | awk '{ print ($10 > 0.062 && $10 < 0.066 ? "turned by 0.064 rad" : "turned by " $10 " rad") }'
  >   done
  > done
  pioneer: same place, same heading
  turned by 0.064 rad
  pioneer: same place, same heading
  scout: same place, same heading
  turned by 0.064 rad
  scout: same place, same heading
  create: same place, same heading
  turned by 0.064 rad
  create: same place, same heading
