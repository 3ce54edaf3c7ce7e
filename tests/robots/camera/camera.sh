# Shared code of the camera tests: starts a simulated robot in a hall, and runs a program with any
# camera on it.
. ../busy/busy.sh

# Starts the robot: in this world with the world's cameras, or, without an argument, in a hall
# without cameras. $device is its line.
start_robot () {
  rm -f served
  if [ $# = 1 ]; then last=camera; set -- --world $1 --camera 0
  else last=device; set -- --world hall.toml; fi
  frobc serve --robot pioneer --for 1200s --tcp 0 "$@" > served &
  robot=$!
  until_true "grep -q ^$last: served 2> /dev/null"
  device=$(sed -n 's/device: //p' served)
}

end () {
  kill $1 2> /dev/null
  wait $1 2> /dev/null || true
}

# Runs a command while a simulated robot is in the hall.
with_robot () {
  (
    start_robot
    "$@"
    status=$?
    end $robot
    exit $status
  )
}

# Runs the program for this time with this camera; writes `summary`, `messages` and log.csv. Also
# runs the command `$feed` until the program ends; preloads `$fake` into the program.
see () {
  [ -e sees ] || frobc build sees.frob --robot pioneer -o sees
  in_time with_robot see_once "$@"
}

see_once () {
  seconds=$1 camera=$2
  shift 2
  [ -z "$feed" ] || { timeout 600 sh -c "$feed" 2> /dev/null & feeder=$!; }
  preloaded=$fake${LD_PRELOAD:+${fake:+:}$LD_PRELOAD}
  LD_PRELOAD=$preloaded ./sees --device $device --for $seconds --camera $camera --record log.csv "$@" > summary 2> messages
  see_status=$?
  [ -z "$feed" ] || end $feeder
  return $see_status
}

# The same, for a run that must warn about the camera, or must see at least this many frames.
see_warned () { wants='grep -q "^warning: camera" messages'; see "$@"; wants=; }
see_frames () {
  wants="at_least 'camera frames' $1 | grep -q enough"
  shift
  see "$@"
  wants=
}

# Prints a number of the run's summary; if it is at least this value, prints `enough` instead.
at_least () {
  awk -F ': ' -v name="$1" -v least=$2 '$1 == name { print name ": " ($2 >= least ? "enough" : $2) }' summary
}

# Prints the run's warnings, each once and without addresses.
warnings () {
  sed 's|(http://127.0.0.1:[0-9]*/\([a-z]*\))|(http://HOST/\1)|' messages | grep '^warning' | sort -u
}
