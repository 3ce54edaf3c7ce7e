A network camera that sends MJPEG over HTTP: parts with lengths, JPEGs alone, chunks.

  $ . ./camera.sh
  $ ./frames jpeg 60 320 240 > film.mjpeg
  $ python3 server.py film.mjpeg port & server=$!
  $ until_true '[ -e port ]'
  $ address=http://127.0.0.1:$(cat port)
  $ for kind in good bare chunked; do
  >   see_frames 10 3 $address/$kind; sed -n 's/^camera: \(.*\);.*/\1/p' summary; at_least 'camera frames' 10
  > done
  320 x 240, colours, JPEG
  camera frames: enough
  320 x 240, colours, JPEG
  camera frames: enough
  320 x 240, colours, JPEG
  camera frames: enough

A server that hangs, sends rubbish or ends its stream: the program receives no events, the run keeps
its rate, and a message gives the reason.

  $ for kind in hangs silent rubbish noise page forbidden missing; do
  >   see_warned 2 $address/$kind; sed -n 's/^late/late/p' summary; warnings
  > done
  late steps: 0
  warning: camera `camera` (http://HOST/hangs) delivers no frames: the server accepts connections but sends no complete picture; check the camera and the address of its stream
  late steps: 0
  warning: camera `camera` (http://HOST/silent) delivers no frames: the server accepts connections but sends no complete picture; check the camera and the address of its stream
  late steps: 0
  warning: camera `camera` (http://HOST/rubbish) delivers no frames: the server accepts connections but sends no complete picture; check the camera and the address of its stream
  late steps: 0
  warning: camera `camera` (http://HOST/noise) delivers no frames: the server does not speak HTTP; check the port
  late steps: 0
  warning: camera `camera` (http://HOST/page) delivers no frames: the server answers with text/html, which is not a stream of pictures; look up the path of the stream in the camera's manual
  late steps: 0
  warning: camera `camera` (http://HOST/forbidden) delivers no frames: the server answers with 401 and requires a password: configure it to send its stream without one
  late steps: 0
  warning: camera `camera` (http://HOST/missing) delivers no frames: the server answers with 404, so this path does not exist; look up the path of the stream in the camera's manual
  $ see_warned 2 http://127.0.0.1:1/stream; warnings | sed 's|(http[^)]*)|(ADDRESS)|'
  warning: camera `camera` (ADDRESS) delivers no frames: cannot connect to port 1 of 127.0.0.1: Connection refused; check that the camera is on, and that the address and port are right
  $ see_warned 2 http://nowhere.invalid/stream; warnings | sed 's|(http[^)]*)|(ADDRESS)|; s|: [^:;]*;|: REASON;|'
  warning: camera `camera` (ADDRESS) delivers no frames: cannot find the address of nowhere.invalid: REASON; check the name, and that this machine is on the same network

The program can detect it, too: the age of the newest frame grows, and the camera is no longer
alive.

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

Truncated JPEGs are dropped; the complete ones between them are frames.

  $ see_frames 10 2 $address/truncated; at_least 'camera frames' 10; at_least 'camera frames not seen' 8; warnings
  camera frames: enough
  camera frames not seen: enough
  $ see_warned 2 $address/cut; sed -n 's/^camera frames/camera frames/p' summary; warnings
  camera frames: 0
  camera frames not seen: 0
  warning: camera `camera` (http://HOST/cut) delivers no frames: a JPEG is damaged: Corrupt JPEG data: premature end of data segment

A frozen camera keeps sending the same frame. After a second its frames no longer count: the
program's camera is not alive, and it stops.

  $ speeds () { grep -v '^#' log.csv | sed 's/"[^"]*"//' | awk -F, 'NR > 1 && $31 > 0 { drove = 1 } END { print drove, $31 }'; }
  $ wants='grep -q "^warning: camera" messages && speeds | grep -q "^1 0\$"'; see 5 $address/frozen; wants=; warnings
  warning: camera `camera` (http://HOST/frozen) delivers no frames: it is frozen: all its frames are identical; unplug it and plug it in again, or set frozen=0 if identical frames are correct
  $ speeds
  1 0
  $ see 3 $address/frozen --set camera.frozen=0; warnings
  $ tail -1 log.csv | sed 's/"[^"]*"//' | awk -F, '{ print ($31 > 0) }'
  1

If the server disappears and returns, so do the frames; the program continues.

  $ start_robot
  $ rm log.csv
  $ ./sees --device $device --for 600 --camera $address/good --record log.csv > summary 2> messages & run=$!
  $ until_true 'grep -q "number = 5" log.csv 2> /dev/null'
  $ end $server
  $ until_true 'grep -q "delivers no frames" messages'
  $ python3 server.py film.mjpeg port & server=$!
  $ until_true 'grep -q "frames again" messages'
  $ kill -INT $run; wait $run
  [4]
  $ sed 's/(http[^)]*)/(ADDRESS)/; s/no frames: .*/no frames: REASON/; s/at [0-9.]* s/at N s/' messages | uniq
  warning: camera `camera` (ADDRESS) delivers no frames: REASON
  camera `camera` (ADDRESS) delivers frames again
  interrupted at N s: the summary covers the run until then, and so does log.csv; run the same command again to start over and overwrite that file
  error: the run was ended by an interrupt; sent a stop command to the robot

If the capture process is killed, another one replaces it.

  $ rm log.csv
  $ ./sees --device $device --for 600 --camera $address/good --record log.csv > summary 2> messages & run=$!
  $ until_true 'grep -q "number = 5" log.csv 2> /dev/null'
  $ keeper=$(cut -d ' ' -f 1 /proc/$run/task/$run/children)
  $ kill -SEGV $(cat /proc/$keeper/task/$keeper/children)
  $ until_true 'grep -q "frames again" messages'
  $ kill -INT $run; wait $run
  [4]
  $ sed 's/(http[^)]*)/(ADDRESS)/; s/port [0-9]* of/port N of/; s/at [0-9.]* s/at N s/' messages
  warning: camera `camera` (ADDRESS) delivers no frames: its capture process was killed by signal 11 (Segmentation fault); restarting it
  camera `camera` (ADDRESS) delivers frames again
  interrupted at N s: the summary covers the run until then, and so does log.csv; run the same command again to start over and overwrite that file
  error: the run was ended by an interrupt; sent a stop command to the robot
  $ end $server
  $ end $robot
