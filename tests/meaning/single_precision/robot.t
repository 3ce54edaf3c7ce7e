A robot's struct has doubles, its program floats: the table for hosts converts. A recording contains
the values that the program received, so it replays bit for bit, with both engines.

  $ cp -rL ../../../examples/wall_follow ../../../examples/bug .
  $ chmod -R u+w wall_follow bug
  $ run () { frobc run $1/$1.frob --real float --for 5s --record $1.csv | grep -E 'simulated:|collisions'; }
  $ replay () {
  >   frobc trace $1/$1.frob --robot pioneer --real float --input $1.csv > c.csv &&
  >   frobc trace $1/$1.frob --robot pioneer --real float --engine interp --input $1.csv | cmp - c.csv &&
  >   head -1 c.csv && wc -l < c.csv &&
  >   awk -F, 'NR == FNR { out[FNR] = $0; columns = NF; next }
  >            { row = $1; for (i = NF - columns + 2; i <= NF; i++) row = row "," $i
  >              if (row != out[FNR]) print "differs: " row " " out[FNR] }' c.csv $1.csv
  > }
  $ run wall_follow
  time simulated: 5.000 s
  collisions: 0
  $ replay wall_follow
  time,out.forward,out.turn
  252
  $ run bug
  time simulated: 5.000 s
  collisions: 0
  $ replay bug
  time,out.forward,out.turn,out.result
  252

The program's C has its own structs.

  $ frobc compile wall_follow/wall_follow.frob --robot pioneer --real float
  $ grep include wall_follow.h
  #include <stdbool.h>
  #include <stdint.h>
  $ grep -A 3 'struct wall_follow_output {' wall_follow.h
  struct wall_follow_output {
      float forward;
      float turn;
  };

A program that ends stores its result after the robot's struct.

  $ cat > errand.frob <<EOF
  > import Geometry
  > import Robot
  > 
  > main = reactimateTask (do
  >     driveTo (Vec2 { x = 0.3[m], y = 0 })
  >     sleepT 0.5[s] (roMake (setVelTR 0 1[rad/s]))
  >     return (Just 0.1))
  > EOF
  $ frobc run errand.frob --robot pioneer --real float --for 20s --exit-when-done --record errand.csv | grep -v -E 'second|log|driven|odometry'
  time simulated: 1.620 s
  collisions: 0
  finished after: 1.620 s
  result: Just 0.1
  $ mkdir errand && cp errand.frob errand
  $ replay errand
  time,out.forward,out.turn,out.result
  83
  $ tail -1 c.csv
  1.620000000,0,0,Just 0.1
