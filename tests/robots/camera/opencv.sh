# Tests the example with OpenCV: it must follow the ball, and its recording must replay bit for bit.
# Skipped if OpenCV is not installed.
example=$1
world=$2
export CPLUS_INCLUDE_PATH=/usr/include/opencv4
if ! libraries=$(sh "$example/libraries.sh") || [ ! -e $CPLUS_INCLUDE_PATH/opencv2/video/tracking.hpp ]; then
  echo "skipped: OpenCV is not installed (libopencv-dev)"
  exit 0
fi
set -e
frobc run "$example/opencv_foreign.frob" --with "$example/camshift.cc" $libraries \
  --world "$world" --for 20s --record opencv.csv > opencv.summary
awk -F ': ' '
  /^collisions/ { ok += $2 == 0 }
  /^mean ball distance error/ { ok += $2 + 0 < 0.06 }
  END { print ok == 2 ? "ok follows the ball by OpenCV" : "FAIL"; exit ok != 2 }' opencv.summary
frobc trace "$example/opencv_foreign.frob" --robot pioneer --with "$example/camshift.cc" $libraries \
  --input opencv.csv > opencv.replayed
grep -v '^#' opencv.csv | sed 's/"[^"]*"//' | cut -d, -f1,31- | cmp - opencv.replayed
echo "ok and replays"
