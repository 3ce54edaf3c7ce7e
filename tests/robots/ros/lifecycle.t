With `--lifecycle`, a program is a managed node: here with the fake ROS 2, in
which another node requests transitions at given times.

  $ . ./ros.sh
  $ managed () { run_node "$1" "$2" --lifecycle; cat messages; }

The program drives while the node is active. Its time stands still in between,
so it runs for one second altogether.

  $ speeds="0 0.2 0 0.2 0"
  $ managed 1s "configure=0.1 activate=0.3 deactivate=0.8 activate2=1.5"; cat velocities
  0.000 0.000
  0.200 0.000
  0.000 0.000
  0.200 0.000
  0.000 0.000
  $ awk -F, 'NR > 2 && $1 - last > 0.3 { print "a gap before", $1 } { last = $1 }' log.csv
  $ frobc trace --robot ros drive.frob --input log.csv | awk -F, '{ print $(NF - 1), $NF }' >replayed
  $ awk -F, '{ print $(NF - 1), $NF }' log.csv | cmp - replayed

A transition that is not possible is refused. A shutdown ends the run.

  $ speeds=""; managed 9s "activate=0.1 configure=0.2 shutdown=0.4"
  warning: the transition `activate` is not possible in the state `unconfigured`; possible: `configure`, `shutdown`

If the node is configured again, the program starts again.

  $ speeds="0 0.2 0 0.2 0"
  $ managed 9s "configure=0.1 activate=0.2 deactivate=0.8 cleanup=1 configure2=1.2 activate2=1.4 shutdown=2"
  warning: the recording ends here, because the program was reset

The option is for nodes.

  $ frobc run drive.frob --lifecycle
  error: --lifecycle only works with --ros2: add --ros2, or remove --lifecycle
  [2]
