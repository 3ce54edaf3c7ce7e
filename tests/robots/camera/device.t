A camera of this computer, through Video4Linux. No camera is required: a preloaded library simulates
one and its faults.

  $ . ./camera.sh
  $ frobc build sees.frob --robot pioneer -o sees
  $ fake=$PWD/fake_camera.so
  $ export FAKE_STATE=$PWD/state FAKE_FRAMES=$PWD/film FAKE_SIZE=64x48 FAKE_FORM
  $ echo good > state

It delivers raw frames or JPEG; if no size is requested, the camera's size is used.

  $ of () { FAKE_FORM=$1; ./frames $2 40 64 48 > film; see_frames 10 3 /dev/video7; sed -n 's/^camera: \(.*\);.*/\1/p' summary; at_least 'camera frames' 10; }
  $ of YUYV yuyv
  64 x 48, colours, YUYV at 30 Hz
  camera frames: enough
  $ of GREY pgm
  64 x 48, grey, GREY at 30 Hz
  camera frames: enough
  $ of MJPG jpeg
  64 x 48, colours, MJPG at 30 Hz
  camera frames: enough

The age of a frame is computed from the driver's timestamp.

  $ grep -o 'age = [0-9.]*' log.csv | awk '{ if ($3 > 0 && $3 < 0.2) good++ } END { print (good > 5) }'
  1

A requested size must be one of the camera's, and so must the format.

  $ see_warned 2 /dev/video7 --set camera.width=320 --set camera.height=240; cat messages
  warning: camera `camera` (/dev/video7) delivers no frames: it cannot deliver frames of 320 x 240, only of 64 x 48: set width and height to that size
  $ FAKE_FORM=H264; see_warned 2 /dev/video7; cat messages
  warning: camera `camera` (/dev/video7) delivers no frames: it supports none of the formats YUYV, MJPEG and grey; use ffmpeg to write its frames to a pipe as raw frames

A fault: the program has no frames, keeps its rate, and stops as programmed, and a message gives the
reason. When the camera works again, so does the program.

  $ # FORM KIND STATE: good, then in that state, then good again
  $ through () {
  >   FAKE_FORM=$1
  >   ./frames $2 40 64 48 > film
  >   echo good > state
  >   rm -f log.csv
  >   LD_PRELOAD=$fake${LD_PRELOAD:+:$LD_PRELOAD} ./sees --device $device --for 600 --camera /dev/video7 --record log.csv > summary 2> messages & run=$!
  >   until_true 'grep -q "number = 9" log.csv 2> /dev/null'
  >   echo $3 > state
  >   until_true 'grep -q "delivers no frames" messages'
  >   tail -1 log.csv | sed 's/"[^"]*"//' | awk -F, '{ print "speed:", $31 }'
  >   echo good > state
  >   until_true 'grep -q "frames again" messages'
  >   kill -INT $run; wait $run
  >   sed -n 's/^late/late/p' summary
  >   grep camera messages | uniq
  > }
  $ in_time with_robot through YUYV yuyv unplugged
  speed: 0
  late steps: 0
  warning: camera `camera` (/dev/video7) delivers no frames: it cannot be opened: No such file or directory; plug it in, or use a device that `ls /dev/video*` lists
  camera `camera` (/dev/video7) delivers frames again
  $ in_time with_robot through YUYV yuyv silent
  speed: 0
  late steps: 0
  warning: camera `camera` (/dev/video7) delivers no frames: the driver has no frame; unplug the camera and plug it in again, or use another camera
  camera `camera` (/dev/video7) delivers frames again
  $ in_time with_robot through YUYV yuyv frozen
  speed: 0
  late steps: 0
  warning: camera `camera` (/dev/video7) delivers no frames: it is frozen: all its frames are identical; unplug it and plug it in again, or set frozen=0 if identical frames are correct
  camera `camera` (/dev/video7) delivers frames again
  $ in_time with_robot through YUYV yuyv short
  speed: 0
  late steps: 0
  warning: camera `camera` (/dev/video7) delivers no frames: a frame is truncated; try another cable or hub
  camera `camera` (/dev/video7) delivers frames again
  $ in_time with_robot through YUYV yuyv damaged
  speed: 0
  late steps: 0
  warning: camera `camera` (/dev/video7) delivers no frames: the driver reports a damaged frame; try another cable or hub
  camera `camera` (/dev/video7) delivers frames again
  $ in_time with_robot through MJPG jpeg short | sed 's/not a JPEG: .*/not a JPEG: REASON/'
  speed: 0
  late steps: 0
  warning: camera `camera` (/dev/video7) delivers no frames: a frame is not a JPEG: REASON
  camera `camera` (/dev/video7) delivers frames again

A driver that does not return from a call blocks only the capture process, which is restarted.

  $ in_time with_robot through YUYV yuyv hanging
  speed: 0
  late steps: 0
  warning: camera `camera` (/dev/video7) delivers no frames: its capture process hangs in a system call: restarting it
  camera `camera` (/dev/video7) delivers frames again

A camera that another process uses, and a device that is not a camera.

  $ FAKE_FORM=YUYV; echo busy > state; see_warned 2 /dev/video7; cat messages
  warning: camera `camera` (/dev/video7) delivers no frames: another program uses it: end that program first
  $ see_warned 2 /dev/null; cat messages
  warning: camera `camera` (/dev/null) delivers no frames: it is not a camera (Inappropriate ioctl for device): use a device that `ls /dev/video*` lists
