If the option is set, a violated assertion stops the robot; it is reported in any case.

  $ . ./robot.sh
  $ start_robot
  $ cat > soon.frob <<'END'
  > import Robot
  > 
  > main :: (HasOdometry i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.1[m/s] 0) where
  >     assert "is over soon" (time () < 0.5[s])
  >     assert "is slow" (velocity i < 1[m/s]))
  > END
  $ told () { sed -n 's/[0-9]*\.[0-9]\{3\}/N/; s/[0-9]* instants*$/N/; /^assert/p; /^error/p'; }
  $ frobc run soon.frob --robot pioneer --device ./line --for 1s --asserts=stop --record run.csv > out 2>&1
  [4]
  $ told < out
  assert "is over soon": violated, first at N s; in total at N
  assert "is slow": held
  error: "is over soon" (soon.frob:5) was violated at N s; sent a stop command to the robot
  $ tail -1 run.csv | sed 's/.*,\([^,]*,[^,]*\)$/\1/'
  Fails,Holds
  $ frobc run soon.frob --robot pioneer --device ./line --for 1s > out 2>&1
  $ told < out
  assert "is over soon": violated, first at N s; in total at N
  assert "is slow": held

An executable has its assertions if it was built with them.

  $ frobc build soon.frob --robot pioneer -o plain && frobc build soon.frob --robot pioneer --asserts=count -o watched
  $ ./plain --device ./line --for 0.7 | told
  $ ./watched --device ./line --for 0.7 --stop-when-violated > out 2>&1
  [4]
