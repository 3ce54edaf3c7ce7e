The behaviour of each capability on each robot. `--robot` also applies to signal functions that
require capabilities. The rows of input list only the columns that differ from 0, false or no event.

  $ trace () {
  >   robot=$1 program=$2; shift 2
  >   echo time | frobc trace $program --robot $robot --input - 2>&1 |
  >     sed -n 's/.*the header for this program is `\(.*\)`/\1/p' | tr ',' '\n' > columns
  >   tr '\n' ',' < columns | sed 's/,$//' > in.csv
  >   echo >> in.csv
  >   for row in "$@"; do
  >     echo "$row" | tr ' ' '\n' > said
  >     awk -F= 'FILENAME == "said" { value[$1] = $2; next }
  >       { v = $0 in value ? value[$0] : $0 == "time" ? 0 : /sonar|key/ ? "" : /umper|Stall|motorsOn|bump|Drop|cliffs|virtualWall|Overcurrent|Button|charging|obeying|emergencyStop/ ? "false" : 0
  >         printf "%s%s", (FNR > 1 ? "," : ""), v } END { print "" }' said columns >> in.csv
  >   done
  >   frobc trace --lint $program --robot $robot --input in.csv > compiled.csv
  >   frobc trace $program --robot $robot --input in.csv --engine interp | cmp - compiled.csv
  >   cat compiled.csv
  > }

Odometry and the battery, on all three robots, whose wheels have different
distances.

  $ cat > common.frob <<'FROB'
  > import Geometry
  > import Robot
  > main :: (HasOdometry i, HasBattery i) => SF i (Point2, Velocity, AngularVelocity, Float[V])
  > main = proc i -> (place i, velocity i, turnRate i, batteryVoltage i)
  > FROB
  $ for robot in pioneer scout create; do
  >   trace $robot common.frob "in.odometry.position.x=1 in.odometry.position.y=2 in.leftWheel=0.1 in.rightWheel=0.3 in.battery=12" | sed 1d
  > done
  0.000000000,1,2,0.20000000000000001,0.55999999999999994,12
  0.000000000,1,2,0.20000000000000001,0.57937427578215517,12
  0.000000000,1,2,0.20000000000000001,0.85106382978723405,12

Bumpers: a Pioneer has one in front, which counts for both sides; a Scout has six, of which the
first is in front; those of a Create are in front.

  $ cat > bumpers.frob <<'FROB'
  > import Robot
  > main :: HasBumpers i => SF i (Bool, Bool, Bool, Bool)
  > main = arr (\i -> (bumpedLeft i, bumpedRight i, bumpedBehind i, bumped i))
  > FROB
  $ trace pioneer bumpers.frob in.frontBumper=true in.rearBumper=true time=1
  time,out.1,out.2,out.3,out.4
  0.000000000,true,true,false,true
  0.000000000,false,false,true,true
  1.000000000,false,false,false,false
  $ trace scout bumpers.frob in.bumpers[0]=true in.bumpers[1]=true in.bumpers[2]=true in.bumpers[3]=true in.bumpers[4]=true in.bumpers[5]=true | sed 1d
  0.000000000,true,true,false,true
  0.000000000,true,false,false,true
  0.000000000,false,false,true,true
  0.000000000,false,false,true,true
  0.000000000,false,false,true,true
  0.000000000,false,true,false,true
  $ trace create bumpers.frob in.bumpLeft=true in.bumpRight=true | sed 1d
  0.000000000,true,false,false,true
  0.000000000,false,true,false,true

A ring of sonars returns the position and the reading of each sonar.

  $ cat > ring.frob <<'FROB'
  > import Geometry
  > import Robot
  > main :: HasSonarRing i => SF i (Distance, Distance, Angle, Angle, Event Distance)
  > main = arr (\i -> left (sonars i ! 4)) where
  >     left s = (s.seat.position.x, s.seat.position.y, s.seat.heading, s.halfAngle, s.echo)
  > FROB
  $ trace pioneer ring.frob in.sonar[4]=1.5 | sed 1d
  0.000000000,0.16600000000000001,-0.027,-0.17453292519943295,0.20943951023931956,1.5
  $ trace scout ring.frob in.sonar[4]=1.5 time=1 | sed 1d
  0.000000000,1.2246467991473533e-17,0.20000000000000001,1.5707963267948966,0.17453292519943295,1.5
  1.000000000,1.2246467991473533e-17,0.20000000000000001,1.5707963267948966,0.17453292519943295,

The reflectance that a Create's front cliff sensors measure, from no reflection to white; brighter
floors count as white.

  $ cat > floor.frob <<'FROB'
  > import Robot
  > main :: HasFloorSensors i => SF i (Float, Float)
  > main = arr (\i -> (floorLeft i, floorRight i))
  > FROB
  $ trace create floor.frob "in.cliffSignals[0]=4000 in.cliffSignals[1]=150 in.cliffSignals[2]=1500" "in.cliffSignals[2]=2000 in.cliffSignals[3]=4000" | sed 1d
  0.000000000,0.10000000000000001,1
  0.000000000,0,1

Distances: for a robot at rest, the distances ahead, to the left and to the
right are those of the echoes; before the first echo, the maximum range.

  $ cat > distances.frob <<'FROB'
  > import Robot
  > main :: HasSonar i => SF i (Distance, Distance, Distance, Distance)
  > main = proc i -> (frontSonar i, sideSonar i, rightSonar i, sonarReach i)
  > FROB
  $ trace pioneer distances.frob time=0 "time=1 in.sonar[0]=1 in.sonar[7]=2" | sed 1d
  0.000000000,5,5,5,5
  1.000000000,5,1,2,5
  $ trace scout distances.frob time=0 "time=1 in.sonar[0]=3 in.sonar[4]=1 in.sonar[12]=2" | sed 1d
  0.000000000,6.4770000000000003,6.4770000000000003,6.4770000000000003,6.4770000000000003
  1.000000000,3,1,2,6.4770000000000003
  $ trace create distances.frob time=0 "time=1 in.light[2]=250 in.light[3]=10 in.light[5]=9" | sed 1d
  0.000000000,0.5,0.5,0.5,0.5
  1.000000000,0.10994802246432496,0.14219524194891453,0.20076599666389083,0.5

Capabilities that only a Create has:

  $ cat > create.frob <<'FROB'
  > import Robot
  > main :: (HasCliffs i, HasStall i, HasBeacon i, HasLight o, HasSound o, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> command i) where
  >     tone i = if cliffRight i then Event (Tone { pitch = 440[Hz], lasting = 0.5[s] }) else NoEvent
  >     light i = if cliffLeft i then On else Off
  >     v i = case beaconSeen i of
  >         Just n -> 0.1[m/s] * toFloat n
  >         Nothing -> if wheelDropped i || stalled i then -0.1[m/s] else 0
  >     command i = roMake (setVelTR (v i) 0 . setLight (light i) . playTone (tone i))
  > FROB
  $ trace create create.frob in.cliffs[0]=true in.cliffs[1]=true in.cliffs[2]=true in.cliffs[3]=true in.beacon=3 in.leftDrop=true in.rightOvercurrent=true | cut -d, -f1,2,5,10-
  time,out.forward,out.powerLight,out.tone
  0.000000000,0,1,
  0.000000000,0,1,
  0.000000000,0,0,"Tone {pitch = 440, lasting = 0.5}"
  0.000000000,0,0,"Tone {pitch = 440, lasting = 0.5}"
  0.000000000,0.30000000000000004,0,
  0.000000000,-0.10000000000000001,0,
  0.000000000,-0.10000000000000001,0,

Under `watching` a robot keeps all its capabilities: its sensors remain accessible.

  $ cat > watched.frob <<'FROB'
  > import Robot
  > 
  > all :: (HasOdometry i, HasSonar i, HasBumpers i, HasConsole i, HasBattery i, DiffDrive o) => Task i o ()
  > all = mkTask (proc i -> (roMake (setVelTR 0 0), edge (bumped i || batteryVoltage i < 11[V])))
  > 
  > ring :: (HasSonarRing i, DiffDrive o) => Task i o ()
  > ring = mkTask (proc i -> (roMake (setVelTR 0 0), edge (isEvent (sonars i ! 3).echo)))
  > 
  > floor' :: (HasCliffs i, HasStall i, HasFloorSensors i, HasBeacon i, DiffDrive o) => Task i o ()
  > floor' = mkTask (proc i -> (roMake (setVelTR 0 0), edge (cliffAhead i || wheelDropped i || stalled i)))
  > 
  > main :: (HasSonar i, HasBumpers i, HasConsole i, HasBattery i, DiffDrive o) => Program i o
  > main = reactimateTask (watching all)
  > 
  > withRing :: (HasSonarRing i, DiffDrive o) => Program i o
  > withRing = reactimateTask (watching ring)
  > 
  > onFloor :: (HasSonar i, HasCliffs i, HasStall i, HasFloorSensors i, HasBeacon i, DiffDrive o) => Program i o
  > onFloor = reactimateTask (watching floor')
  > FROB
  $ for robot in pioneer scout create; do frobc compile watched.frob --robot $robot -o $robot && ls $robot; done
  watched.c
  watched.h
  watched.c
  watched.h
  watched.c
  watched.h
  $ frobc compile watched.frob --entry withRing --robot scout -o ring && ls ring
  watched.c
  watched.h
  $ frobc compile watched.frob --entry onFloor --robot create -o floor && ls floor
  watched.c
  watched.h
