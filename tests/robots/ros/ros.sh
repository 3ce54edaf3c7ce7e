# Helpers of the tests: programs as nodes of the fake ROS 2 in fake/, which has one robot.
. ../busy/busy.sh

sh fake/build.sh fake "$PWD/prefix"
AMENT_PREFIX_PATH=$PWD/prefix; export AMENT_PREFIX_PATH
FAKE_ROS_LOG=$PWD/velocities; export FAKE_ROS_LOG

# Messages may be late by almost as much as the robot waits for them.
patient="--patience 1s --set late=1"

run_once() {
    : >velocities
    FAKE_ROS=$faults frobc run --ros2 "$@" >summary 2>messages
}

# Whether the robot received these forward speeds, such as `0 0.2 0`.
speeds_are() {
    [ "$(awk '/^[0-9]/ { printf "%s%g", (n++ > 0 ? " " : ""), $1 }' velocities)" = "$1" ]
}

# run_ros PROGRAM [OPTION]... : runs a program as a node, with the faults `$faults` of fake_ros.c, and
# writes `summary`, `messages` and `velocities`. If the machine is too slow for this in real time, the
# robot receives other speeds than `$speeds`, and the run is repeated in slow time.
run_ros() {
    program=$1
    shift
    wants='speeds_are "$speeds"'
    in_time run_once "$program" $patient "$@"
    status=$?
    wants=
    return $status
}

# run_node SECONDS FAULTS [OPTION]... : runs drive.frob in this way.
run_node() {
    seconds=$1 faults=$2
    shift 2
    run_ros drive.frob --for "$seconds" --record log.csv "$@"
}

# start_node : starts it in the background, in slow time, as a group of processes, and waits until the
# robot drives. Sets `run`, `controller` and `node` to process ids.
start_node() {
    rm -f velocities; : >velocities
    FROB_SLOW=4 LD_PRELOAD=$slow setsid ./drive --patience 1 --set late=1 --record log.csv \
        >summary 2>messages &
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
