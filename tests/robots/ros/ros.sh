# Helpers of the tests: programs as nodes of the fake ROS 2 in fake/, which has one robot. They run in
# virtual time, so their results do not depend on how busy the machine is.
. ../busy/busy.sh

sh fake/build.sh fake "$PWD/prefix"
AMENT_PREFIX_PATH=$PWD/prefix; export AMENT_PREFIX_PATH
FAKE_ROS_LOG=$PWD/velocities; export FAKE_ROS_LOG

virtual=$(cd ../virtual && pwd)
"$virtual/clock" "$PWD/time" 1000 >clock_started 2>&1 &
until_true '[ -s clock_started ]'

# Runs a command in virtual time.
virtually() { FROB_VIRTUAL=$PWD/time LD_PRELOAD=$virtual/virtual.so "$@"; }

patient="--patience 1s --set late=1"

run_once() {
    : >velocities
    FAKE_ROS=$faults virtually frobc run --ros2 "$@" >summary 2>messages
}

# Whether the robot received these forward speeds, such as `0 0.2 0`.
speeds_are() {
    [ "$(awk '/^[0-9]/ { printf "%s%g", (n++ > 0 ? " " : ""), $1 }' velocities)" = "$1" ]
}

# run_ros PROGRAM [OPTION]... : runs a program as a node, with the faults `$faults` of fake_ros.c, and
# writes `summary`, `messages` and `velocities`. Reports if the robot receives other speeds than
# `$speeds`.
run_ros() {
    program=$1
    shift
    run_once "$program" $patient "$@"
    status=$?
    speeds_are "$speeds" || cat velocities
    return $status
}

# run_node SECONDS FAULTS [OPTION]... : runs drive.frob in this way.
run_node() {
    seconds=$1 faults=$2
    shift 2
    run_ros drive.frob --for "$seconds" --record log.csv "$@"
}

# start_node : starts it in the background, as a group of processes, and waits until the robot
# drives. Sets `run`, `controller` and `node` to process ids. The virtual time runs at most at a quarter
# of real time, so that the test can act while the robot drives.
start_node() {
    [ -s slow_started ] || {
        "$virtual/clock" "$PWD/slow_time" 0.25 >slow_started 2>&1 &
        until_true '[ -s slow_started ]'
    }
    rm -f velocities; : >velocities
    FROB_VIRTUAL=$PWD/slow_time LD_PRELOAD=$virtual/virtual.so setsid ./drive --patience 1 \
        --set late=1 --record log.csv >summary 2>messages &
    run=$!
    until_true 'grep -q "^0.200" velocities'
    set -- $(cat /proc/$run/task/$run/children)
    controller=$1 node=$2
}

# Waits until the newest velocity is zero.
until_stopped() {
    until_true '[ "$(tail -1 velocities)" = "0.000 0.000" ]'
    echo "last velocity: $(tail -1 velocities)"
}
