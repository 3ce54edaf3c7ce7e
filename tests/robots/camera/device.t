A camera of this computer, by Video4Linux. There need be none: what is preloaded plays one, and what
can be the matter with it.

  $ . ./camera.sh
  $ start_robot
  $ frobc build sees.frob --robot pioneer -o sees
  $ look () { seconds=$1; shift; LD_PRELOAD=$PWD/fake_camera.so see $seconds /dev/video7 "$@"; }
  $ export FAKE_STATE=$PWD/state FAKE_FRAMES=$PWD/film FAKE_SIZE=64x48 FAKE_FORM
  $ echo good > state

It gives frames as they are, or JPEG; with a size that nobody has asked for, it is the camera's.

  $ of () { FAKE_FORM=$1; ./frames $2 40 64 48 > film; look 3; sed -n 's/^camera: \(.*\);.*/\1/p' summary; at_least 'camera frames' 10; }
  $ of YUYV yuyv
  64 x 48, colours, YUYV at 30 Hz
  camera frames: enough
  $ of GREY pgm
  64 x 48, grey, GREY at 30 Hz
  camera frames: enough
  $ of MJPG jpeg
  64 x 48, colours, MJPG at 30 Hz
  camera frames: enough

The age of a frame counts from the driver's stamp.

  $ grep -o 'age = [0-9.]*' log.csv | awk '{ if ($3 > 0 && $3 < 0.2) good++ } END { print (good > 5) }'
  1

A size that is set has to be the camera's, and so has the form.

  $ look 2 --set camera.width=320 --set camera.height=240; cat messages
  warning: camera `camera` (/dev/video7) gives no frames: it gives no frames of 320 x 240, but of 64 x 48: set width and height to these
  $ FAKE_FORM=H264; look 2; cat messages
  warning: camera `camera` (/dev/video7) gives no frames: it gives its frames in no form that is known here (YUYV, MJPEG, grey); let ffmpeg read it, into a pipe of raw frames

Something is the matter with it: the program has no frames, keeps its time, stops as it says, and a
message tells why. When all is well again, so is the program.

  $ # FORM KIND STATE: good, then in that state, then good again
  $ through () {
  >   FAKE_FORM=$1
  >   ./frames $2 40 64 48 > film
  >   echo good > state
  >   LD_PRELOAD=$PWD/fake_camera.so ./sees --device $device --for 60 --camera /dev/video7 --record log.csv > summary 2> messages & run=$!
  >   until_true 'grep -q "number = 9" log.csv 2> /dev/null'
  >   echo $3 > state
  >   until_true 'grep -q "gives no frames" messages'
  >   tail -1 log.csv | sed 's/"[^"]*"//' | awk -F, '{ print "speed:", $31 }'
  >   echo good > state
  >   until_true 'grep -q "frames again" messages'
  >   kill -INT $run; wait $run
  >   sed -n 's/^late/late/p' summary
  >   grep camera messages | uniq
  >   rm log.csv
  > }
  $ through YUYV yuyv unplugged
  speed: 0
  late steps: 0
  warning: camera `camera` (/dev/video7) gives no frames: it cannot be opened: No such file or directory; is it plugged in? `ls /dev/video*` shows what is there
  camera `camera` (/dev/video7) gives frames again
  $ through YUYV yuyv silent
  speed: 0
  late steps: 0
  warning: camera `camera` (/dev/video7) gives no frames: the driver has no frame; plug the camera out and in again, or another into its place
  camera `camera` (/dev/video7) gives frames again
  $ through YUYV yuyv frozen
  speed: 0
  late steps: 0
  warning: camera `camera` (/dev/video7) gives no frames: it has frozen: it gives the same frame again and again, to the last bit; plug it out and in again, or set frozen=0 if such frames are right
  camera `camera` (/dev/video7) gives frames again
  $ through YUYV yuyv short
  speed: 0
  late steps: 0
  warning: camera `camera` (/dev/video7) gives no frames: a frame is cut short; is the cable or the hub a bad one?
  camera `camera` (/dev/video7) gives frames again
  $ through YUYV yuyv damaged
  speed: 0
  late steps: 0
  warning: camera `camera` (/dev/video7) gives no frames: the driver says that a frame is damaged; is the cable or the hub a bad one?
  camera `camera` (/dev/video7) gives frames again
  $ through MJPG jpeg short
  speed: 0
  late steps: 0
  warning: camera `camera` (/dev/video7) gives no frames: a frame is no JPEG: Invalid JPEG file structure: missing SOS marker
  camera `camera` (/dev/video7) gives frames again

A driver that does not come back from a call holds nobody up but the process that captures, which is
begun anew.

  $ through YUYV yuyv hanging
  speed: 0
  late steps: 0
  warning: camera `camera` (/dev/video7) gives no frames: its source does not come back from a call of the system: it begins anew
  camera `camera` (/dev/video7) gives frames again

Who else has it, and what is no camera.

  $ FAKE_FORM=YUYV; echo busy > state; look 2; cat messages
  warning: camera `camera` (/dev/video7) gives no frames: another program uses it: end that first
  $ see 2 /dev/null; cat messages
  warning: camera `camera` (/dev/null) gives no frames: it is no camera (Inappropriate ioctl for device): `ls /dev/video*` shows them
  $ end $robot
