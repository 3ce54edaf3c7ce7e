Whatever is wrong with a camera of any kind, the program receives no more events, the age of the
newest frame grows, the camera is not alive, a message gives the reason, and the robot's steps keep
their rate.

  $ . ./camera.sh
  $ frobc build sees.frob --robot pioneer -o sees
  $ cat > ages.frob <<'FROB'
  > import Robot
  > import Vision
  > 
  > -- | The age of the newest frame, and whether the camera is alive.
  > main :: (HasCamera i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (frameAge (camera i) * 1[m/s^2]) (if cameraAlive 0.5[s] i then 1[rad/s] else 0)))
  > FROB

The last half second of a run with a fault; the robot stands still as well.

  $ judge () { # NAME
  >   frobc trace ages.frob --robot pioneer --input log.csv > ages.csv
  >   grep -v '^#' log.csv | sed 's/"[^"]*"//' | awk -F, 'END { print $31 }' > drive
  >   awk -F, -v name="$1" -v drive="$(cat drive)" -v late="$(sed -n 's/^late steps: //p' summary)" -v said="$(grep -c '^warning: camera' messages)" '
  >     NR > 1 { time[NR] = $1; age[NR] = $2; alive[NR] = $3 }
  >     END {
  >       for (k = NR; k > 2 && time[k] > time[NR] - 0.5; k--) {
  >         if (age[k] <= age[k - 1]) younger++
  >         if (alive[k] != 0) lives++
  >       }
  >       print name ":", (younger ? "has frames" : "no frames, age grows") ",", (lives ? "alive" : "not alive") ",",
  >         (said ? "told" : "not told") ",", (drive == 0 ? "stands" : "drives") ",", (late ? late " late steps" : "in time")
  >     }' ages.csv
  > }
  $ ./frames yuyv 40 64 48 > film; ./frames jpeg 40 320 240 > film.mjpeg; mkfifo pipe

Devices that fail after a second:

  $ export FAKE_STATE=$PWD/state FAKE_FRAMES=$PWD/film FAKE_SIZE=64x48 FAKE_FORM=YUYV
  $ for state in good unplugged silent frozen short damaged hanging; do
  >   fake=$PWD/fake_camera.so feed="echo good > state; sleep 1.5; echo $state > state"
  >   case $state in good) see 6 /dev/video7 ;; *) see_warned 6 /dev/video7 ;; esac; judge $state
  > done; fake= feed=
  good: has frames, alive, not told, drives, in time
  unplugged: no frames, age grows, not alive, told, stands, in time
  silent: no frames, age grows, not alive, told, stands, in time
  frozen: no frames, age grows, not alive, told, stands, in time
  short: no frames, age grows, not alive, told, stands, in time
  damaged: no frames, age grows, not alive, told, stands, in time
  hanging: no frames, age grows, not alive, told, stands, in time

Folders, files and pipes:

  $ mkdir folder; for k in 1 2 3 4 5; do ./frames ppm 1 32 24 $k > folder/$k.ppm; done
  $ see_warned 3 folder; judge 'a folder that is over'
  a folder that is over: no frames, age grows, not alive, told, stands, in time
  $ see_warned 3 film.mjpeg; judge 'a file that is over'
  a file that is over: no frames, age grows, not alive, told, stands, in time
  $ see_warned 3 nothing; judge 'none there'
  none there: no frames, age grows, not alive, told, stands, in time
  $ feed='(./frames ppm 5 32 24; sleep 60) > pipe'; see_warned 4 pipe; judge 'a pipe that falls silent'
  a pipe that falls silent: no frames, age grows, not alive, told, stands, in time
  $ feed='(./frames ppm 5 32 24; while ./frames ppm 1 24 32; do sleep 0.1; done) > pipe'; see_warned 4 pipe; judge 'another size'
  another size: no frames, age grows, not alive, told, stands, in time
  $ feed='(./frames ppm 5 32 24; while ./frames rgb 1 24 32; do sleep 0.1; done) > pipe'; see_warned 4 pipe; judge 'rubbish'; feed=
  rubbish: no frames, age grows, not alive, told, stands, in time

Servers (one that hangs after some frames receives a new request, and sends the same frames again:
network.t):

  $ python3 server.py film.mjpeg port & server=$!
  $ until_true '[ -e port ]'
  $ for kind in silent rubbish noise page missing cut; do
  >   see_warned 4 http://127.0.0.1:$(cat port)/$kind; judge $kind
  > done
  silent: no frames, age grows, not alive, told, stands, in time
  rubbish: no frames, age grows, not alive, told, stands, in time
  noise: no frames, age grows, not alive, told, stands, in time
  page: no frames, age grows, not alive, told, stands, in time
  missing: no frames, age grows, not alive, told, stands, in time
  cut: no frames, age grows, not alive, told, stands, in time
  $ end $server
