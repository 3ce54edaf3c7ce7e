A node publishes its instants, so a bag has a recording of the program. `frobc
trace` runs the program again on it, with the same outputs, bit for bit.

  $ . ./ros.sh
  $ speeds="0 0.2 0" FAKE_ROS_BAG=$PWD/sent; export FAKE_ROS_BAG
  $ record () { rm -f sent.*; run_once "$@"; }
  $ cat >paced.frob <<END
  > import Robot
  > param pace :: Velocity = 0.2[m/s]
  > main :: (HasOdometry i, HasConsole i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (limit i) 0)) where
  >     limit i = if (place i).x < knob "far" 0 2[m] 0.1[m] i then pace else 0
  > END
  $ record paced.frob $patient --for 0.8s --record log.csv --ros-args -p pace:=0.3 --; cat messages; speeds_are "0 0.3 0"
  $ python3 bag.py sent bag /paced; cp sent.columns other.columns; cp sent.instants other.instants
  $ frobc trace paced.frob --input bag --output replayed.csv
  $ column () { awk -F, -v name="$1" '!/^#/ { for (i = 1; at == 0 && i <= NF; i++) if ($i == name) at = i; print $at }' "$2"; }
  $ column out.forward log.csv >recorded; column out.forward replayed.csv | cmp - recorded
  $ wc -l <recorded | awk '{ print ($1 > 20) }'
  1

The bag also has the values of parameters, and the columns of the recording.

  $ frobc trace paced.frob --input bag/bag_0.db3 | sort -t, -k2 -g | tail -1 | cut -d, -f2
  0.29999999999999999
  $ frobc view bag paced.frob --why-nan

The instants of a program can be turned off.

  $ faults= ; record paced.frob $patient --for 0.1s --set instants=0; ls sent.* 2>/dev/null
  [2]

A program with several nodes, two runs in one bag, or a recorder that started
late:

  $ record drive.frob $patient --for 0.3s; cp sent.columns one.columns; cp sent.instants one.instants
  $ frobc trace paced.frob --input none.db3
  error: cannot read the bag none.db3: it does not exist
  [2]
  $ python3 bag.py one of_drive /drive; frobc trace paced.frob --input of_drive
  error: cannot read the bag of_drive: it has no instants of the program paced, only of drive
  [2]
  $ python3 bag.py one of_drive /other; frobc trace drive.frob --input of_drive
  error: cannot read the bag of_drive: drive ran as several nodes: /drive, /other
  [2]
  $ python3 bag.py one late /drive 7; frobc trace drive.frob --input late
  error: cannot read the bag late: it lacks the first 7 instants of /drive, so it cannot be replayed: start `ros2 bag record` before the program
  [2]
  $ python3 bag.py one gap /drive 0 3; python3 bag.py one gap /drive 6; frobc trace drive.frob --input gap | wc -l
  warning: the bag lacks instants of /drive from number 4 on; the replay ends before them
  5
  $ rm sent.*; record drive.frob $patient --for 0.3s --rate 25
  $ python3 bag.py one both /drive; python3 bag.py sent both /drive; frobc trace drive.frob --input both
  error: cannot read the bag both: it has several runs of /drive: record each run in a separate bag
  [2]
  $ python3 bag.py one several /drive; python3 bag.py other several /paced; frobc trace drive.frob --input several | wc -l >rows
  $ python3 bag.py one alone /drive; frobc trace drive.frob --input alone | wc -l | cmp - rows
  $ mkdir empty; frobc trace drive.frob --input empty
  error: cannot read the bag empty: the folder has no .db3 or .mcap files, so it is not a bag
  [2]
  $ : >empty/bag_0.db3.zstd; frobc trace drive.frob --input empty
  error: cannot read the bag empty: its files are compressed: run `zstd -d` on them
  [2]
  $ frobc trace drive.frob --input empty/bag_0.db3.zstd
  error: cannot read the bag empty/bag_0.db3.zstd: it is compressed: run `zstd -d` on it
  [2]
  $ echo nonsense >bad.db3; frobc trace drive.frob --input bad.db3
  error: cannot read the bag bad.db3: file is not a database
  [2]
  $ sqlite () { python3 -c 'import sqlite3, sys; d = sqlite3.connect(sys.argv[1]); d.executescript(sys.argv[2]); d.commit()' "$@"; }
  $ python3 bag.py one damaged /drive; sqlite damaged/bag_0.db3 "UPDATE messages SET data = x'00010000ffffff7f00'"
  $ frobc trace drive.frob --input damaged
  error: cannot read the bag damaged: a message from the program is damaged
  [2]
  $ python3 bag.py one strangers /drive; sqlite strangers/bag_0.db3 "UPDATE topics SET name = '/chatter'"
  $ frobc trace drive.frob --input strangers
  error: cannot read the bag strangers: it contains no recording of a program: record the topics NODE/columns and NODE/instants
  [2]
