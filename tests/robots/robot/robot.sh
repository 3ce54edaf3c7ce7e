# Shared code of tests with real hosts: starts a simulated robot behind a pseudo-terminal, and reads
# the commands it received.
. ../busy/busy.sh

# Starts the robot ($kind selects it), and waits for its line: $robot is its process, `line` a link
# to the device, `told` the log of commands.
kind=pioneer
start_robot () {
  rm -f line told
  world=hall.toml
  [ "$1" = --world ] && { world=$2; shift 2; }
  frobc serve --robot $kind --world $world --for 600s --link line --log told "$@" > served &
  robot=$!
  until_true '[ -e line ]'
}

# Starts the program on the robot, and waits until it drives: $run is the process that owns the
# line; $controller, $guard and $second_guard are its children. Clears the log of commands first.
start_driving () {
  : > told
  [ -e drive ] || frobc build drive.frob --robot pioneer -o drive
  ./drive --device ./line --for 60 --progress "$@" > summary 2> messages &
  run=$!
  until_true 'grep -q "VEL 300" told'
  set -- $(cat /proc/$run/task/$run/children)
  controller=$1 guard=$2 second_guard=$3
}

mark () { marked=$(wc -l < told); }

# Whether the robot has received this command since the mark.
told () { tail -n +$((marked + 1)) told | grep -q "$1"; }

# Waits for a stop command; prints the robot's last speed command.
until_stopped () {
  until_true 'told STOP'
  awk '$2 == "VEL" { v = $3 } END { print "last speed:", v }' told
}

end_robot () {
  kill $robot
  wait $robot
}
