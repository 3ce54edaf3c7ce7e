# What the tests of real robots share: a simulated one behind a pseudo-terminal,
# and what it was told.

# Starts the robot ($kind of one), and waits for its line: $robot is its process,
# `line` a link to the device, `told` the log of commands.
kind=pioneer
start_robot () {
  rm -f line told
  world=hall.toml
  [ "$1" = --world ] && { world=$2; shift 2; }
  frobc serve --robot $kind --world $world --for 120s --link line --log told "$@" > served &
  robot=$!
  until_true '[ -e line ]'
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

# Starts the program on the robot, and waits until it drives: $run is the
# process that holds the line, $controller and $guard are its children. What the
# robot was told before is forgotten.
start_driving () {
  : > told
  [ -e drive ] || frobc build drive.frob --robot pioneer -o drive
  ./drive --device ./line --for 60 --progress "$@" > summary 2> messages &
  run=$!
  until_true 'grep -q "VEL 300" told'
  set -- $(cat /proc/$run/task/$run/children)
  controller=$1 guard=$2
}

mark () { marked=$(wc -l < told); }

# Since the mark the robot was told this.
told () { tail -n +$((marked + 1)) told | grep -q "$1"; }

# The speed that the robot was told last, once it has been told a stop.
until_stopped () {
  until_true 'told STOP'
  awk '$2 == "VEL" { v = $3 } END { print "last speed:", v }' told
}

end_robot () {
  kill $robot
  wait $robot
}

# Runs a command that drives the robot in real time and leaves its `summary`; again,
# at most three times in all, if the machine was too busy for instants to come in
# time: such a run says nothing about the program.
in_real_time () {
  for attempt in 1 2 3; do
    "$@"
    awk -F ': ' '{ value[$1] = $2 } END { exit value["overruns"] * 50 > value["steps"] }' summary && return
  done
}
