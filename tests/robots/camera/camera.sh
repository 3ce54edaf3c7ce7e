# What the tests of cameras share: a simulated robot that stands in a hall, and runs of a program
# that sees with any camera.

# Starts the robot, in this world with the world's cameras, or else in a hall without any; $device
# is its line.
start_robot () {
  rm -f served
  if [ $# = 1 ]; then last=camera; set -- --world $1 --camera 0
  else last=device; set -- --world hall.toml; fi
  frobc serve --robot pioneer --for 300s --tcp 0 "$@" > served &
  robot=$!
  until_true "grep -q ^$last: served 2> /dev/null"
  device=$(sed -n 's/device: //p' served)
}

# Waits up to 15 s for a condition.
until_true () {
  for attempt in $(seq 300); do
    eval "$1" && return 0
    sleep 0.05
  done
  echo "in vain: $1"
  return 1
}

end () {
  kill $1
  wait $1 2> /dev/null || true
}

# Runs the program for so long with this camera; leaves `summary`, `messages` and log.csv.
see () {
  seconds=$1 camera=$2
  shift 2
  [ -e sees ] || frobc build sees.frob --robot pioneer -o sees
  ./sees --device $device --for $seconds --camera $camera --record log.csv "$@" > summary 2> messages
}

# What the run says of a number: the words for at least so many, or the number.
at_least () {
  awk -F ': ' -v name="$1" -v least=$2 '$1 == name { print name ": " ($2 >= least ? "enough" : $2) }' summary
}

# The run's warnings, each once, without addresses.
warnings () {
  sed 's|(http://127.0.0.1:[0-9]*/\([a-z]*\))|(http://HOST/\1)|' messages | grep '^warning' | sort -u
}
