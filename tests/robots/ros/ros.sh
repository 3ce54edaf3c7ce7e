# Helpers of the tests: programs as nodes of the fake ROS 2 in fake/, which has one robot.

sh fake/build.sh fake "$PWD/prefix"
AMENT_PREFIX_PATH=$PWD/prefix; export AMENT_PREFIX_PATH
FAKE_ROS_LOG=$PWD/velocities; export FAKE_ROS_LOG

# On a busy machine, messages may be late.
patient="--patience 1s --set late=1"

# Runs a command, and runs it again if the machine was too slow for it: if messages were late that
# the robot does not delay, or steps took too long.
steady() {
    for attempt in 1 2 3 4 5 6; do
        : >velocities
        "$@" >steady.out 2>steady.err
        steady_status=$?
        grep -qE "no message on|s late; late|stopping the robot" steady.err || break
    done
    cat steady.out
    cat steady.err >&2
    return $steady_status
}

# run_node SECONDS FAULTS [OPTION]... : runs drive.frob with at most five options; faults are those
# of fake_ros.c. A robot with the faults `silent` and `old` delays its messages itself.
run_node() {
    case $2 in *silent* | *old*) repeat=env ;; *) repeat="steady env" ;; esac
    rm -f velocities; : >velocities
    $repeat FAKE_ROS="$2" timeout 60 frobc run --ros2 drive.frob --for "$1" --record log.csv \
        $patient ${3+"$3"} ${4+"$4"} ${5+"$5"} ${6+"$6"} ${7+"$7"} >summary 2>messages
}

# start_node FAULTS : starts it in the background, as a group of processes, and waits until the robot
# drives. Sets `run`, `controller` and `node` to
# process ids.
start_node() {
    rm -f velocities; : >velocities
    FAKE_ROS=$1 setsid ./drive --patience 1 --set late=1 --record log.csv >summary 2>messages &
    run=$!
    until_true 'grep -q "^0.200" velocities'
    set -- $(cat /proc/$run/task/$run/children)
    controller=$1 node=$2
}

until_true() {
    for i in $(seq 400); do
        eval "$1" && return
        sleep 0.02
    done
    echo "never: $1"
}

# Waits until the newest velocity is zero.
until_stopped() {
    until_true '[ "$(tail -1 velocities)" = "0.000 0.000" ]'
    echo "last velocity: $(tail -1 velocities)"
}
