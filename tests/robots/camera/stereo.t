A stereo head with two cameras, whose frames have different times: the host combines the frames that
are closest in time.

  $ . ./camera.sh
  $ cat > both.frob <<'FROB'
  > import Robot
  > import Stereo
  > import Vision
  > 
  > -- | Drives while there are pairs; how far apart they were taken is its turn.
  > main = reactimateRobot (proc i -> drive (stereo i)) where
  >     drive = proc pair -> roMake (setVelTR (if timeSince (isEvent pair) < 0.5[s] then 0.1[m/s] else 0) (hold 0 (mapE (\s -> 1[rad/s^2] * s.apart) pair)))
  > FROB
  $ frobc build both.frob --robot pioneer -o both
  $ both_once () {
  >   seconds=$1
  >   shift
  >   timeout 600 sh -c "$feed wait" 2> /dev/null & feeder=$!
  >   ./both --device $device --for $seconds --record log.csv "$@" > summary 2> messages
  >   end $feeder
  > }
  $ both () { in_time with_robot both_once "$@"; }
  $ frames_of () { # PIPE PERIOD FIRST
  >   echo "(sleep $3; for k in \$(seq 0 400); do ./frames ppm 1 32 24 \$k || break; sleep $2; done) > $1 &"
  > }
  $ mkfifo one two

Cameras without a common clock, one twice as fast as the other: all pairs are close in time, and
frames without a partner are skipped and counted.

  $ near () { awk -F '[ :]+' '/^time between the frames/ { print ($12 < 45 ? "near" : $0) }' summary; }
  $ feed="$(frames_of one 0.05 0) $(frames_of two 0.1 0.01)"
  $ wants="at_least pairs 20 | grep -q enough && near | grep -q near"
  $ both 5 --camera left=one --camera right=two
  $ warnings; at_least pairs 20; at_least 'left frames not seen' 15
  warning: cameras `left` and `right` have the same position, so no depth can be computed: set their positions, such as `--set left.left=0.06 --set right.left=-0.06` for two cameras that are 12 cm apart
  pairs: enough
  left frames not seen: enough
  $ awk -F '[ :]+' '/^(left|right) frames/ && $3 != "not" { n[$1] = $3 } /^pairs:/ { print (n["left"] == $2 && n["right"] == $2) }' summary; near
  1
  near
  $ grep -v '^#' log.csv | sed 's/"[^"]*"//g' | cut -d, -f1,32- > recorded.csv
  $ frobc trace both.frob --robot pioneer --input log.csv | cmp - recorded.csv
  $ frobc trace both.frob --robot pioneer --input log.csv --engine interp | cmp - recorded.csv

If no frames are as close as required, the program has no pairs, the robot
stands still, and a message suggests a fix. If the frames of one camera arrive
later, it states by how much.

  $ feed="$(frames_of one 0.1 0) $(frames_of two 0.1 0.15)"
  $ wants="grep -q '^warning.*give no pairs' messages"
  $ both 4 --camera left=one --camera right=two --set left.pair_within=0.0000001 --set right.latency=0.05 --set left.left=0.1
  $ sed -n 's/^late/late/p' summary; at_least 'pair failures' 1
  late steps: 0
  pair failures: enough
  $ warnings | sed 's/taken [0-9]* ms/taken N ms/'
  warning: cameras `left` and `right` deliver no pairs of frames: the closest frames were taken N ms apart, but the maximum is 0 ms (pair_within): make both cameras take frames at the same time and rate, or increase pair_within; if the frames of one camera arrive later, set its latency to the difference
  $ tail -1 log.csv | sed 's/"[^"]*"//g' | awk -F, '{ print $32 }'
  0

If one camera falls silent and returns, so do the pairs; a message names the camera.

  $ feed="$(frames_of one 0.05 0) (for k in \$(seq 0 20); do ./frames ppm 1 32 24 \$k; sleep 0.05; done; sleep 2; for k in \$(seq 0 400); do ./frames ppm 1 32 24 \$k || break; sleep 0.05; done) > two &"
  $ wants="grep -q 'frames again' messages"
  $ both 6 --camera left=one --camera right=two --set left.left=0.1
  $ grep camera messages
  warning: camera `right` (two) delivers no frames: no complete frame has arrived: send PPM, PGM or JPEG, or set width and height for raw frames
  camera `right` (two) delivers frames again
  $ grep -v '^#' log.csv | sed 's/"[^"]*"//g' | awk -F, 'NR > 1 { if ($32 > 0 != drives) print (drives = $32 > 0) ? "drives" : "stands" }'
  drives
  stands
  drives

A served robot offers both cameras: a program drives it down the corridor with them, as in the
simulator.

  $ example=../../../examples/corridor_stereo
  $ drive_down () {
  >   start_robot $example/world.toml
  >   set -- $(sed -n 's/camera: //p' served)
  >   frobc run $example/corridor_stereo.frob --device $device --camera left=$1 --camera right=$2 --set left.left=0.06 --set right.left=-0.06 --set left.field_of_view_deg=75 --set right.field_of_view_deg=75 --for 90s --exit-when-done > summary
  >   end $robot
  > }
  $ wants="at_least pairs 200 | grep -q enough"
  $ in_time drive_down
  $ sed -n 's/^result/result/p; s/failures/failures/p' summary; at_least pairs 200
  left failures: 0
  right failures: 0
  pair failures: 0
  result: ()
  pairs: enough
  $ awk -F '[ ,]+' '/^position/ { print ($2 > 7.6 && ($4 - 0.9) ^ 2 < 0.1 ^ 2) ? "at the end, in the middle" : $0 }; /^collisions/' served
  at the end, in the middle
  collisions: 0
