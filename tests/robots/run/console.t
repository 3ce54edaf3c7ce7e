Typed keys drive the robot: each key is an event at one instant, in the order typed; the robot
continues with the last command.

  $ cat > keys.frob <<'FROB'
  > import Robot
  > 
  > -- | w: ahead, s: back, blank: stand still.
  > speed :: Int -> Velocity
  > speed key = if key == 119 then 0.2[m/s] else if key == 115 then -0.2[m/s] else 0
  > 
  > main :: (HasConsole i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (hold 0 (mapE speed (keyPressed i))) 0))
  > FROB
  $ for robot in pioneer scout create; do
  >   printf 'ws ' | frobc run keys.frob --robot $robot --console --rate 10 --for 0.5s --record run.csv > summary
  >   key=$(head -1 run.csv | tr ',' '\n' | grep -n '^in.key$' | cut -d: -f1)
  >   forward=$(head -1 run.csv | tr ',' '\n' | grep -n '^out.forward$' | cut -d: -f1)
  >   cut -d, -f1,$key,$forward run.csv
  > done
  time,in.key,out.forward
  0.000000000,119,0.20000000000000001
  0.100000000,115,-0.20000000000000001
  0.200000000,32,0
  0.300000000,,0
  0.400000000,,0
  0.500000000,,0
  time,in.key,out.forward
  0.000000000,119,0.20000000000000001
  0.100000000,115,-0.20000000000000001
  0.200000000,32,0
  0.300000000,,0
  0.400000000,,0
  0.500000000,,0
  time,in.key,out.forward
  0.000000000,119,0.20000000000000001
  0.100000000,115,-0.20000000000000001
  0.200000000,32,0
  0.300000000,,0
  0.400000000,,0
  0.500000000,,0

Without `--console` keys are ignored, and the recording replays as it was.

  $ printf 'ws ' | frobc run keys.frob --robot scout --rate 10 --for 0.2s --record quiet.csv > summary
  $ cut -d, -f31,32 quiet.csv
  in.emergencyStop,in.key
  false,
  false,
  false,
  $ printf 'w' | frobc run keys.frob --robot scout --console --rate 10 --for 0.2s --record run.csv > summary
  $ frobc trace keys.frob --robot scout --input run.csv
  time,out.forward,out.turn
  0.000000000,0.20000000000000001,0
  0.100000000,0.20000000000000001,0
  0.200000000,0.20000000000000001,0
