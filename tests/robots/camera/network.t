A camera on a network, which gives MJPEG over HTTP: parts with their lengths, JPEGs alone, chunks.

  $ . ./camera.sh
  $ start_robot
  $ ./frames jpeg 60 320 240 > film.mjpeg
  $ python3 server.py film.mjpeg port & server=$!
  $ until_true '[ -e port ]'
  $ address=http://127.0.0.1:$(cat port)
  $ for kind in good bare chunked; do
  >   see 3 $address/$kind; sed -n 's/^camera: \(.*\);.*/\1/p' summary; at_least 'camera frames' 10
  > done
  320 x 240, colours, JPEG
  camera frames: enough
  320 x 240, colours, JPEG
  camera frames: enough
  320 x 240, colours, JPEG
  camera frames: enough

A server that hangs, sends rubbish or ends its stream: the program's event does not come, the run
goes on in its time, and a message says why.

  $ for kind in hangs silent rubbish noise page forbidden missing; do
  >   see 2 $address/$kind; sed -n 's/^late/late/p' summary; warnings
  > done
  late steps: 0
  warning: camera `camera` (http://HOST/hangs) gives no frames: the server is connected and sends no picture that is whole; is the camera in order, and is this the address of its stream?
  late steps: 0
  warning: camera `camera` (http://HOST/silent) gives no frames: the server is connected and sends no picture that is whole; is the camera in order, and is this the address of its stream?
  late steps: 0
  warning: camera `camera` (http://HOST/rubbish) gives no frames: the server is connected and sends no picture that is whole; is the camera in order, and is this the address of its stream?
  late steps: 0
  warning: camera `camera` (http://HOST/noise) gives no frames: what answers there does not speak HTTP; is the port right?
  late steps: 0
  warning: camera `camera` (http://HOST/page) gives no frames: the server answers with text/html, which is no stream of pictures; the camera's manual says which path has one
  late steps: 0
  warning: camera `camera` (http://HOST/forbidden) gives no frames: the server answers with 401: it lets only those in whom it knows; have it give its stream without a password
  late steps: 0
  warning: camera `camera` (http://HOST/missing) gives no frames: the server answers with 404: it has nothing of this path; the camera's manual says which its stream has
  $ see 2 http://127.0.0.1:1/stream; warnings | sed 's|(http[^)]*)|(ADDRESS)|'
  warning: camera `camera` (ADDRESS) gives no frames: there is no connection to port 1 of 127.0.0.1: Connection refused; is the camera turned on, and are address and port right?
  $ see 2 http://nowhere.invalid/stream; warnings | sed 's|(http[^)]*)|(ADDRESS)|; s|: [^:;]*;|: REASON;|'
  warning: camera `camera` (ADDRESS) gives no frames: there is no address of nowhere.invalid: REASON; is its name right, and is this machine on its network?

The program sees it, too: the age of the newest frame grows, and the camera is no longer alive.

  $ cat > ages.frob <<'FROB'
  > import Robot
  > import Vision
  > 
  > main :: (HasCamera i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (frameAge (camera i) * 0.1[m/s^2]) (if cameraAlive 0.5[s] i then 1[rad/s] else 0)))
  > FROB
  $ see 3 $address/hangs
  $ frobc trace ages.frob --robot pioneer --input log.csv | awk -F, 'NR > 1 { if ($3 == 1) lived = 1; dead = lived && $3 == 0 ? dead + 1 : 0; if (dead > 1 && $2 <= before) print "no older"; before = $2; if (dead > longest) { longest = dead; age = $2 } } END { print (longest > 10 && age > 0.08) }'
  1

JPEGs that are cut short are no frames; the whole ones between them are.

  $ see 2 $address/truncated; at_least 'camera frames' 10; at_least 'camera frames not seen' 8; warnings
  camera frames: enough
  camera frames not seen: enough
  $ see 2 $address/cut; sed -n 's/^camera frames/camera frames/p' summary; warnings
  camera frames: 0
  camera frames not seen: 0
  warning: camera `camera` (http://HOST/cut) gives no frames: a JPEG is damaged: Corrupt JPEG data: premature end of data segment

A camera that has frozen sends frames without an end, all the same one. After a second they are
none any more: the program's camera is not alive, and it stops.

  $ see 5 $address/frozen; warnings
  warning: camera `camera` (http://HOST/frozen) gives no frames: it has frozen: it gives the same frame again and again, to the last bit; plug it out and in again, or set frozen=0 if such frames are right
  $ grep -v '^#' log.csv | sed 's/"[^"]*"//' | awk -F, 'NR > 1 && $31 > 0 { drove = 1 } END { print drove, $31 }'
  1 0
  $ see 3 $address/frozen --set camera.frozen=0; warnings
  $ tail -1 log.csv | sed 's/"[^"]*"//' | awk -F, '{ print ($31 > 0) }'
  1

Where the server goes and comes back, so do the frames; the program goes on where it was.

  $ rm log.csv
  $ ./sees --device $device --for 30 --camera $address/good --record log.csv > summary 2> messages & run=$!
  $ until_true 'grep -q "number = 5" log.csv 2> /dev/null'
  $ end $server
  $ until_true 'grep -q "gives no frames" messages'
  $ python3 server.py film.mjpeg port & server=$!
  $ until_true 'grep -q "frames again" messages'
  $ kill -INT $run; wait $run
  [4]
  $ sed 's/(http[^)]*)/(ADDRESS)/; s/no frames: .*/no frames: REASON/' messages | uniq
  warning: camera `camera` (ADDRESS) gives no frames: REASON
  camera `camera` (ADDRESS) gives frames again
  error: the run was ended by an interrupt; the robot was told to stop

The process that captures may be killed: another one begins.

  $ rm log.csv
  $ ./sees --device $device --for 30 --camera $address/good --record log.csv > summary 2> messages & run=$!
  $ until_true 'grep -q "number = 5" log.csv 2> /dev/null'
  $ keeper=$(cut -d ' ' -f 1 /proc/$run/task/$run/children)
  $ kill -SEGV $(cat /proc/$keeper/task/$keeper/children)
  $ until_true 'grep -q "frames again" messages'
  $ kill -INT $run; wait $run
  [4]
  $ sed 's/(http[^)]*)/(ADDRESS)/; s/port [0-9]* of/port N of/' messages
  warning: camera `camera` (ADDRESS) gives no frames: what captures it was ended by signal 11 (Segmentation fault); it begins anew
  camera `camera` (ADDRESS) gives frames again
  error: the run was ended by an interrupt; the robot was told to stop
  $ end $server
  $ end $robot
