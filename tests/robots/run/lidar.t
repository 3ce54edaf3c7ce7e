A lidar in the simulator, and the module Lidar.

  $ room () { { echo 'robot = "pioneer"' && cat; } > room.toml && cat >> room.toml <<TOML
  > [start]
  > x = 1.0
  > y = 1.0
  > [[wall]]
  > points = [[0, 0], [6, 0], [6, 4], [0, 4]]
  > closed = true
  > [[circle]]
  > center = [3, 2]
  > radius = 0.3
  > TOML
  > }
  $ program () { cat > "$1.frob" <<FROB
  > import Lidar
  > import Robot
  > main :: (HasLidar i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0.2[1/s]) where
  >     v = hold 0 (mapE (slow $2) (lidar i)))
  > slow :: Angle -> Scan $3 -> Velocity
  > slow width s = if maybe False (< 1[m]) (nearestWithin width 0 s) then 0.1[m/s] else 0.3[m/s]
  > FROB
  > }
  $ program narrow '60[deg]' 72

Each distance is the smallest one among the rays of its sector. Here all of them are compared with
the geometry of the room, for a lidar that is not in the middle of the robot, in a program with 72
directions and in one with 7:

  $ room <<TOML
  > [lidar]
  > ahead = 0.1
  > left = -0.05
  > farthest = 4
  > TOML
  $ frobc run narrow.frob --world room.toml --for 10s --record run.csv > /dev/null
  $ python3 devices.py lidar run.csv 72
  101 scans, worst 0.000, deviation 0.000, unknown 0.000
  $ program wide '120[deg]' 7
  $ frobc run wide.frob --world room.toml --for 10s --record wide.csv > /dev/null
  $ python3 devices.py lidar wide.csv 7
  101 scans, worst 0.000, deviation 0.000, unknown 0.000

A recording contains the scans, so a replay computes the same, in both engines:

  $ frobc trace narrow.frob --robot pioneer --input run.csv --output again.csv
  $ frobc trace narrow.frob --robot pioneer --input run.csv --engine interp --output interpreted.csv
  $ cmp again.csv interpreted.csv
  $ cut -d, -f1 run.csv | wc -l
  502
  $ frobc run narrow.frob --world room.toml --for 10s --real float --record float.csv > /dev/null
  $ frobc trace narrow.frob --real float --robot pioneer --input float.csv --output float_c.csv
  $ frobc trace narrow.frob --real float --robot pioneer --input float.csv --engine interp --output float_i.csv
  $ cmp float_c.csv float_i.csv

Noise, lost rays, and parts of the robot that hide a tenth of the circle. The smallest of several
noisy distances is shorter than the true one, so this program has a direction for each ray:

  $ room <<TOML
  > [lidar]
  > ahead = 0.1
  > left = -0.05
  > farthest = 4
  > noise = 0.02
  > dropout = 0.05
  > masked_deg = [[100.5, 118.5], [-118.5, -100.5]]
  > TOML
  $ program each '60[deg]' 360
  $ frobc run each.frob --world room.toml --for 10s --record noise.csv > /dev/null
  $ python3 devices.py lidar noise.csv 360
  101 scans, worst 0.075, deviation 0.020, unknown 0.147

A lidar with few rays fills all directions; one with a field of view leaves the others unknown:

  $ room <<TOML
  > [lidar]
  > rays = 36
  > TOML
  $ ranges () { sed -n 's/.*"Scan {ranges = \[\([^]]*\)\].*/\1/p' "$1" | head -1 | tr ',' '\n' | sed 's/Just \(.....\).*/\1/; s/^ //' | paste -sd ' ' | fold -sw 90; }
  $ frobc run narrow.frob --world room.toml --for 0.1s --record few.csv > /dev/null
  $ ranges few.csv
  4.949 4.949 5.026 2.064 2.064 1.963 1.963 1.963 4.589 3.850 3.850 3.406 3.406 3.139 3.139 
  2.995 2.995 2.950 2.950 2.950 2.995 2.777 2.777 1.899 1.899 1.477 1.477 1.240 1.240 1.096 
  1.096 1.010 1.010 0.964 0.964 0.949 0.949 0.949 0.964 0.964 1.010 1.010 1.096 1.096 1.240 
  1.240 1.240 1.096 1.096 1.010 1.010 0.964 0.964 0.949 0.949 0.949 0.964 0.964 1.010 1.010 
  1.096 1.096 1.240 1.240 1.477 1.477 1.899 1.899 2.777 2.777 5.026 4.949
  $ room <<TOML
  > [lidar]
  > rays = 19
  > field_of_view_deg = 180
  > yaw_deg = 90
  > TOML
  $ frobc run narrow.frob --world room.toml --for 0.1s --record half.csv > /dev/null
  $ ranges half.csv
  4.949 4.949 5.026 2.064 2.064 1.963 1.963 1.963 4.589 3.850 3.850 3.406 3.406 3.139 3.139 
  2.995 2.995 2.950 2.950 2.950 2.995 2.777 2.777 1.899 1.899 1.477 1.477 1.240 1.240 1.096 
  1.096 1.010 1.010 0.964 0.964 0.949 0.949 0.949 Nothing Nothing Nothing Nothing Nothing 
  Nothing Nothing Nothing Nothing Nothing Nothing Nothing Nothing Nothing Nothing Nothing 
  Nothing Nothing Nothing Nothing Nothing Nothing Nothing Nothing Nothing Nothing Nothing 
  Nothing Nothing Nothing Nothing Nothing Nothing 4.949

Scans arrive at the lidar's rate, with an age:

  $ room <<TOML
  > [lidar]
  > rays = 4
  > rate = 5
  > latency = 0.05
  > TOML
  $ program four '60[deg]' 4
  $ frobc run four.frob --world room.toml --for 1s --record late.csv > /dev/null
  $ sed -n 's/^\([^,]*\),.*\(age = [^}]*\)}.*/\1 \2/p' late.csv
  0.060000000 age = 0.059999999999999998, number = 0
  0.260000000 age = 0.059999999999999998, number = 1
  0.460000000 age = 0.059999999999999998, number = 2
  0.660000000 age = 0.059999999999999998, number = 3
  0.860000000 age = 0.059999999999999998, number = 4

Two lidars with names; the program reads one of them with two sizes:

  $ room <<TOML
  > [[lidar]]
  > name = "front"
  > [[lidar]]
  > name = "rear"
  > TOML
  $ cat > two.frob <<FROB
  > import Lidar
  > import Robot
  > main :: (HasConsole i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (v i) 0))
  > v :: HasConsole i => i -> Velocity
  > v i = if sees (consoleLidar "front" (console i) :: Event (Scan 8)) || sees (consoleLidar "front" (console i) :: Event (Scan 16)) || sees (consoleLidar "rear" (console i) :: Event (Scan 8)) then 0.1[m/s] else 0
  > sees :: Event (Scan n) -> Bool
  > sees s = maybe False (< 1[m]) (fromEvent Nothing (mapE (rangeAt 0) s))
  > FROB
  $ frobc run two.frob --world room.toml --for 1s --record two.csv > /dev/null
  $ head -1 two.csv | tr , '\n' | grep console
  in.console.front 8
  in.console.front 16
  in.console.rear 8
  $ frobc report two.frob --robot scout | grep ' lidar '
    front 8   lidar  8 directions   two.frob:6
    front 16  lidar  16 directions  two.frob:6
    rear 8    lidar  8 directions   two.frob:6

A world without the lidar, and mistakes in a world file:

  $ frobc run narrow.frob --world room.toml --for 1s
  error: the program uses a lidar, `lidar`, but the robot in this world has none with this name; it has `front`, `rear`: add `name = "lidar"` to one of them in the world file, or write [[lidar]] for each and add another one
  [2]
  $ room < /dev/null
  $ frobc run narrow.frob --world room.toml --for 1s
  error: the program uses a lidar, `lidar`, but the robot in this world has none: add a table [lidar] to the world file
  [2]
  $ frobc run two.frob --world room.toml --for 1s 2>&1 | head -1
  error: the program uses a lidar, `front`, but the robot in this world has none: add a table [lidar] with name = "front" to the world file
  $ room <<TOML
  > [[lidar]]
  > rays = 0
  > nearest = 5
  > farthest = 3
  > rate = 1000
  > field_of_view_deg = 400
  > masked_deg = [10, 20]
  > [[lidar]]
  > nois = 1
  > TOML
  $ frobc run narrow.frob --world room.toml --for 1s
  error: room.toml:1:1: two lidars are named `lidar`: give each one its own `name`
  error: room.toml:3:8: `rays` must be a whole number from 1 to 4096
  error: room.toml:5:12: `farthest` must be more than `nearest`, and at most 1000
  error: room.toml:6:8: `rate` must be at most 200, the rate of the physics steps
  error: room.toml:7:21: `field_of_view_deg` must be at most 360
  error: room.toml:8:14: `masked_deg` must be a list of pairs of bearings, such as [[150, 170], [-170, -150]]
  error: room.toml:10:1: unknown key `nois`; did you mean `noise`?
  [2]

Only the simulator has a lidar:

  $ frobc build narrow.frob --robot pioneer -o narrow
  error: narrow uses the lidar `lidar`, but only the simulator has one; for your own robot, let the driver fill a field of the input, and define an instance that reads this field
  [2]

A controller that needs sonars works with a lidar, on every robot:

  $ cat > follow.frob <<FROB
  > import Lidar
  > import Robot
  > import WallFollow
  > main :: (HasOdometry i, HasLidar i, DiffDrive o) => Program i o
  > main = reactimateRobot (byLidar 0.2[m] (wallFollow1 0.5[m]))
  > FROB
  $ cat > around.frob <<FROB
  > import Geometry
  > import Lidar
  > import Motion
  > import Robot
  > main :: (HasOdometry i, HasLidar i, DiffDrive o) => Program i o
  > main = reactimateRobot (byLidar 0.2[m] (proc i -> either id (const restingOutput) (runTask (driveAround Vec2 { x = 4[m], y = 2[m] }) i)))
  > FROB
  $ room <<TOML
  > [lidar]
  > noise = 0.01
  > dropout = 0.05
  > [measure]
  > distance = 0.5
  > TOML
  $ sed -i /^robot/d room.toml
  $ for robot in pioneer scout create; do
  >   frobc run follow.frob --world room.toml --robot $robot --for 60s | grep -e collisions -e 'mean wall'
  >   frobc run around.frob --world room.toml --robot $robot --for 60s | grep -e collisions -e driven
  > done
  mean wall distance error: 0.1243 m
  collisions: 0
  distance driven: 4.794 m
  collisions: 0
  mean wall distance error: 0.0473 m
  collisions: 0
  distance driven: 4.736 m
  collisions: 0
  mean wall distance error: 0.1285 m
  collisions: 0
  distance driven: 4.744 m
  collisions: 0
