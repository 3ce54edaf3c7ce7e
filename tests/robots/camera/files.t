A program with a camera requires one on a robot; without it, the message says how to name it.

  $ . ./camera.sh
  $ start_robot
  $ frobc run sees.frob --robot pioneer --device $device
  error: sees uses a camera, `camera`: add its source with --camera SOURCE, such as /dev/video0 or http://HOST:PORT/PATH
  [2]

A folder of pictures is a camera whose frames come in the order of their names, from the start of
the program.

  $ mkdir pictures
  $ for k in 00 01 02 03 04 05 06 07 08 09 10 11 12 13 14 15 16 17 18 19; do ./frames ppm 1 32 24 ${k#0} > pictures/$k.ppm; done
  $ echo no picture > pictures/notes.txt
  $ see_frames 20 3 pictures --set camera.rate=10 --set camera.up=0.5 --set camera.pitch_deg=20
  $ sed -n 's/^camera/camera/p' summary
  camera: 32 x 24, colours, 20 pictures at 10 Hz; focal length 28 px from its field of view, 0.12 m ahead, 0.00 m to the left, 0.50 m up, tilted down by 20 degrees
  camera frames: 20
  camera frames not seen: 0
  camera failures: 1
  $ warnings
  warning: camera `camera` (pictures) delivers no frames any more: all 20 pictures have been shown

The program receives each of them once, and stops after the last one.

  $ grep -o 'number = [0-9]*' log.csv | awk '{ print $3 - before; before = $3 }' | sort | uniq -c | sed 's/^ *//'
  1 0
  19 1
  $ grep -v '^#' log.csv | sed 's/"[^"]*"//' | awk -F, 'NR > 1 && $31 > 0 { drove = 1 } END { print drove, $31 }'
  1 0

The recording contains the frames, like the simulator's: it replays bit for bit, on both engines.
The folder next to it can be used as a camera again, whose files contain its pose.

  $ ls log.frames | wc -l
  20
  $ grep -v '^#' log.csv | sed 's/"[^"]*"//' | cut -d, -f1,31- > recorded.csv
  $ frobc trace sees.frob --robot pioneer --input log.csv | cmp - recorded.csv
  $ frobc trace sees.frob --robot pioneer --input log.csv --engine interp | cmp - recorded.csv
  $ mv log.frames again
  $ see_frames 1 1 again --set camera.rate=100
  $ sed -n 's/^camera: //p' summary
  32 x 24, colours, 20 pictures at 100 Hz; focal length 28 px from the frame's header, 0.12 m ahead, 0.00 m to the left, 0.50 m up, tilted down by 20 degrees

A pipe of pictures, in any format that contains their size; and of raw frames, whose size is given
by an option. The writer may end, and another one continue.

  $ mkfifo pipe
  $ for kind in ppm pgm jpeg; do
  >   feed="for k in \$(seq 0 20 400); do ./frames $kind 20 64 48 \$k; sleep 0.1; done > pipe"
  >   see_frames 3 3 pipe
  >   sed -n 's/^camera: \(.*\);.*/\1/p' summary; at_least 'camera frames' 3
  > done
  64 x 48, colours, pictures
  camera frames: enough
  64 x 48, grey, pictures
  camera frames: enough
  64 x 48, colours, pictures
  camera frames: enough
  $ feed='./frames rgb 20 64 48 > pipe; sleep 2; for k in $(seq 0 20 400); do ./frames rgb 20 64 48 $k; sleep 0.1; done > pipe'
  $ wants='grep -q "frames again" messages'; see 4 pipe --set camera.width=64 --set camera.height=48; wants=
  $ sed -n 's/^camera: \(.*\);.*/\1/p' summary; at_least 'camera frames' 5; cat messages
  64 x 48, colours, raw frames
  camera frames: enough
  warning: camera `camera` (pipe) delivers no frames: no program writes to the pipe: start the program that sends the frames
  camera `camera` (pipe) delivers frames again
  $ feed=

A file of frames is played at its rate.

  $ ./frames jpeg 10 64 48 > film.mjpeg
  $ see_warned 2 film.mjpeg --set camera.rate=20 --set camera.grey=1
  $ sed -n 's/^camera: \(.*\);.*/\1/p; s/^camera frames/camera frames/p' summary; warnings
  64 x 48, grey, pictures
  camera frames: 10
  camera frames not seen: 0
  warning: camera `camera` (film.mjpeg) delivers no frames any more: the whole file has been shown

Data that is not a frame is rejected with a message; so is a frame of another size than the previous
ones.

  $ wrong () { see_warned 2 "$@"; sed -n 's/^camera frames: /frames: /p; s/^late/late/p' summary; warnings; }
  $ mkdir empty; wrong empty
  late steps: 0
  frames: 0
  warning: camera `camera` (empty) delivers no frames: there is no picture in the folder: add .ppm, .pgm or .jpg files, which are shown in the order of their names
  $ wrong nowhere
  late steps: 0
  frames: 0
  warning: camera `camera` (nowhere) delivers no frames: it cannot be opened: No such file or directory; create a pipe with mkfifo
  $ mkdir bad; head -c 1000 pictures/00.ppm > bad/0.ppm; echo 'P6 99999 99999 255' > bad/1.ppm; wrong bad
  late steps: 0
  frames: 0
  warning: camera `camera` (bad) delivers no frames any more: no picture in the folder could be read; the last error: a frame has 99999 x 99999 pixels, but the maximum is 1920 x 1200: configure the camera to send smaller frames (1.ppm)
  $ feed='(./frames rgb 10 64 48; sleep 60) > pipe'; wrong pipe
  late steps: 0
  frames: 0
  warning: camera `camera` (pipe) delivers no frames: no complete frame has arrived: send PPM, PGM or JPEG, or set width and height for raw frames
  $ feed='(./frames ppm 10 64 48; while ./frames ppm 1 48 64; do sleep 0.1; done) > pipe'; wrong pipe | grep -v ^frames
  late steps: 0
  warning: camera `camera` (pipe) delivers no frames: a frame is 48 x 64, colours, instead of 64 x 48, colours: set width, height and grey to the camera's format, or configure the camera for the expected format
  $ feed=

Wrong options are reported before anything moves.

  $ see 1 pictures --set camera.width=64; cat messages
  error: camera `camera` has only one of width and height: set both, or neither
  $ see 1 pictures --set camera.tilt=3; cat messages
  error: `tilt=3` is not a setting of a camera; write camera.NAME=VALUE with one of: width, height, grey, rate, latency, pair_within, frozen, field_of_view_deg, focal_x, focal_y, centre_x, centre_y, k1, k2, k3, p1, p2, ahead, left, up, yaw_deg, pitch_deg, roll_deg
  $ see 1 pictures --set camera.width=4000 --set camera.height=4000; cat messages
  error: camera `camera`: frames can have at most 1920 x 1200 pixels, not 4000 x 4000
  $ frobc run sees.frob --robot pioneer --camera pictures
  error: --camera only works on a robot: use it with --device or --ros2
  [2]
  $ end $robot
