A program that sees needs a camera on a robot; without one it says how to name it.

  $ . ./camera.sh
  $ start_robot
  $ frobc run sees.frob --robot pioneer --device $device
  error: sees looks through a camera, `camera`: name its source with --camera SOURCE, as /dev/video0 or http://HOST:PORT/PATH
  [2]

A folder of pictures is a camera whose frames come in the order of their names, from when the
program begins.

  $ mkdir pictures
  $ for k in 00 01 02 03 04 05 06 07 08 09 10 11 12 13 14 15 16 17 18 19; do ./frames ppm 1 32 24 ${k#0} > pictures/$k.ppm; done
  $ echo no picture > pictures/notes.txt
  $ see 3 pictures --set camera.rate=10 --set camera.up=0.5 --set camera.pitch_deg=20
  $ sed -n 's/^camera/camera/p' summary
  camera: 32 x 24, colours, 20 pictures at 10 Hz; focal length 28 px by its field of view, 0.12 m ahead, 0.00 m to the left, 0.50 m up, tilted down by 20 degrees
  camera frames: 20
  camera frames not seen: 0
  camera failures: 1
  $ warnings
  warning: camera `camera` (pictures) gives no frames any more: all 20 pictures have been shown

The program was given each of them once, and stops when they are over.

  $ grep -o 'number = [0-9]*' log.csv | awk '{ print $3 - before; before = $3 }' | sort | uniq -c | sed 's/^ *//'
  1 0
  19 1
  $ grep -v '^#' log.csv | sed 's/"[^"]*"//' | awk -F, 'NR > 1 && $31 > 0 { drove = 1 } END { print drove, $31 }'
  1 0

The recording has the frames, as the simulator's has: it replays bit for bit, on both engines, and
the folder beside it is a camera again, which knows itself where it sat.

  $ ls log.frames | wc -l
  20
  $ grep -v '^#' log.csv | sed 's/"[^"]*"//' | cut -d, -f1,31- > recorded.csv
  $ frobc trace sees.frob --robot pioneer --input log.csv | cmp - recorded.csv
  $ frobc trace sees.frob --robot pioneer --input log.csv --engine interp | cmp - recorded.csv
  $ mv log.frames again
  $ see 1 again --set camera.rate=100
  $ sed -n 's/^camera: //p' summary
  32 x 24, colours, 20 pictures at 100 Hz; focal length 28 px as the frame says, 0.12 m ahead, 0.00 m to the left, 0.50 m up, tilted down by 20 degrees

A pipe of pictures, in any of the forms that tell their size; and of raw frames, whose size is
told. Who writes it may end, and another one begin.

  $ mkfifo pipe
  $ for kind in ppm pgm jpeg; do
  >   (for k in $(seq 0 20 400); do ./frames $kind 20 64 48 $k; sleep 0.1; done > pipe) 2> /dev/null &
  >   see 3 pipe
  >   sed -n 's/^camera: \(.*\);.*/\1/p' summary; at_least 'camera frames' 3
  >   wait $!
  > done
  64 x 48, colours, pictures
  camera frames: enough
  64 x 48, grey, pictures
  camera frames: enough
  64 x 48, colours, pictures
  camera frames: enough
  $ (./frames rgb 20 64 48 > pipe; sleep 2; for k in $(seq 0 20 400); do ./frames rgb 20 64 48 $k; sleep 0.1; done > pipe) 2> /dev/null &
  $ see 4 pipe --set camera.width=64 --set camera.height=48
  $ sed -n 's/^camera: \(.*\);.*/\1/p' summary; at_least 'camera frames' 5; cat messages
  64 x 48, colours, raw frames
  camera frames: enough
  warning: camera `camera` (pipe) gives no frames: nobody writes to the pipe: start what gives its frames
  camera `camera` (pipe) gives frames again
  $ wait $!

A file of frames is shown at its rate.

  $ ./frames jpeg 10 64 48 > film.mjpeg
  $ see 2 film.mjpeg --set camera.rate=20 --set camera.grey=1
  $ sed -n 's/^camera: \(.*\);.*/\1/p; s/^camera frames/camera frames/p' summary; warnings
  64 x 48, grey, pictures
  camera frames: 10
  camera frames not seen: 0
  warning: camera `camera` (film.mjpeg) gives no frames any more: all of the file has been shown

What is no frame is none, and is told; so is a frame of another size than those before it.

  $ wrong () { see 2 "$@"; sed -n 's/^camera frames: /frames: /p; s/^late/late/p' summary; warnings; }
  $ mkdir empty; wrong empty
  late steps: 0
  frames: 0
  warning: camera `camera` (empty) gives no frames: there is no picture in the folder: put .ppm, .pgm or .jpg files there, which are taken in the order of their names
  $ wrong nowhere
  late steps: 0
  frames: 0
  warning: camera `camera` (nowhere) gives no frames: it cannot be opened: No such file or directory; a pipe is made by mkfifo
  $ mkdir bad; head -c 1000 pictures/00.ppm > bad/0.ppm; echo 'P6 99999 99999 255' > bad/1.ppm; wrong bad
  late steps: 0
  frames: 0
  warning: camera `camera` (bad) gives no frames any more: no picture of the folder could be read; the last one: a frame has 99999 x 99999 pixels, and there is room for 1920 x 1200: have the camera send smaller ones (1.ppm)
  $ (./frames rgb 10 64 48; sleep 3) > pipe & wrong pipe
  late steps: 0
  frames: 0
  warning: camera `camera` (pipe) gives no frames: what comes is no whole frame: it has to be PPM, PGM or JPEG, or raw frames whose width and height are set
  $ wait $!
  $ (./frames ppm 10 64 48; while ./frames ppm 1 48 64; do sleep 0.1; done) > pipe 2> /dev/null & wrong pipe | grep -v ^frames
  late steps: 0
  warning: camera `camera` (pipe) gives no frames: a frame is 48 x 64, colours, and not 64 x 48, colours as it should be: set width, height and grey to what the camera gives, or the camera to these
  $ wait $!

Wrong options are told before anything moves.

  $ see 1 pictures --set camera.width=64; cat messages
  error: of camera `camera` set both width and height, or none
  $ see 1 pictures --set camera.tilt=3; cat messages
  error: `tilt=3` is no setting of a camera; write camera.NAME=VALUE with one of: width, height, grey, rate, latency, pair_within, frozen, field_of_view_deg, focal_x, focal_y, centre_x, centre_y, k1, k2, k3, p1, p2, ahead, left, up, yaw_deg, pitch_deg, roll_deg
  $ see 1 pictures --set camera.width=4000 --set camera.height=4000; cat messages
  error: camera `camera`: there is room for frames of 1920 x 1200 pixels, and not 4000 x 4000
  $ frobc run sees.frob --robot pioneer --camera pictures
  error: --camera is for a robot, and not for the simulator: it needs --device
  [2]
  $ end $robot
