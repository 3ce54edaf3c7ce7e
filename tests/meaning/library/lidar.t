The functions on scans of the module Lidar.

  $ . ./trace.sh

A scan of eight directions from eight numbers: an object ahead, one at 45 degrees, something nearer
than the range of the lidar, nothing in range, an unknown distance, and objects behind and at the
right side.

  $ cat > scan.frob << 'FROB'
  > import Geometry
  > import Lidar
  > main :: SF (Array 8 Distance) ((Array 8 (Maybe Distance), Array 4 (Maybe Distance), Array 16 (Maybe Distance)), (Array 6 (Maybe Distance), Array 5 (Maybe Distance)), Array 8 (Maybe Point2))
  > main = proc ds ->
  >     ( (scan.ranges, (scanOf 0.1[m] 5[m] ds :: Scan 4).ranges, (scanOf 0.1[m] 5[m] ds :: Scan 16).ranges)
  >     , ( map (`rangeAt` scan) [0, 45[deg], 67[deg], 68[deg], -90[deg], 270[deg]]
  >       , [ nearestWithin 0 0 scan, nearestWithin 100[deg] 0 scan, nearestWithin 100[deg] 180[deg] scan
  >         , nearestWithin 0 90[deg] scan, nearestWithin 700[deg] 0 scan] )
  >     , objects scan ) where
  >     scan = (scanOf 0.1[m] 5[m] ds :: Scan 8)
  > FROB
  $ echo 2,1,0.05,inf,nan,4,3,7 | rows 'in[0],in[1],in[2],in[3],in[4],in[5],in[6],in[7]' | trace scan | cells | sed 's/Nothing/-/g; s/Just //g; s/Vec2 //g'
  2,1,-,5,-,4,3,5,1,1,4,3,2,1,1,1,-,5,5,5,-,4,4,3,3,3,5,2,2,1,1,-,3,3,2,1,4,-,1,"{x = 2, y = 0}","{x = 0.70710678118654757, y = 0.70710678118654746}",-,-,-,"{x = -2.8284271247461898, y = -2.8284271247461903}","{x = 1.8369701987210297e-16, y = -3}",-
  $ single scan

The bearings of directions, and the direction of a bearing:

  $ cat > bearings.frob << 'FROB'
  > import Lidar
  > main :: SF Float (Array 4 Float, Array 5 Int)
  > main = proc x -> (map (\a -> a / 1[deg]) bearings, map (directionOf 36) [x * 1[deg], 4.9[deg], -4.9[deg], -5.1[deg], 180[deg]])
  > FROB
  $ printf '%s\n' 0 354.9 355.1 726 | rows in | trace bearings | cells
  0,90,180,-90,0,0,0,35,18
  0,90,180,-90,35,0,0,35,18
  0,90,180,-90,0,0,0,35,18
  0,90,180,-90,1,0,0,35,18
  $ single bearings

`latestScan` returns the newest scan until it is half a second old, including its age on arrival:

  $ cat > latest.frob << 'FROB'
  > import Lidar
  > data Robot = Robot { seen :: Event Distance }
  > instance HasLidar Robot where
  >     lidar i = mapE (\d -> (scanOf 0 5[m] [d]) { age = 0.1[s] }) i.seen
  > main :: SF Robot (Maybe Distance)
  > main = proc i -> maybe Nothing (rangeAt 0) (latestScan 0.5[s] i :: Maybe (Scan 1))
  > FROB
  $ printf 'time,in.seen\n0,\n0.1,2\n0.2,\n0.4,\n0.5,\n0.6,3\n0.9,\n1.1,\n' | trace latest | cells
  Nothing
  Just 2
  Just 2
  Just 2
  Nothing
  Just 3
  Just 3
  Nothing
  $ single latest

The distances that `byLidar` computes, before and after scans. The robot stands still; the pillar
ahead is 0.5 m from the lidar, which is 0.1 m ahead of the middle, and walls are 1 m away on the left
and 0.7 m on the right. Objects disappear after half a second:

  $ cat > senses.frob << 'FROB'
  > import Capability
  > import Geometry
  > import Lidar
  > data Robot = Robot { seen :: Event () }
  > instance HasOdometry Robot where
  >     robotPose _ = Pose { position = zeroVec, heading = 0 }
  >     velocity = constant 0
  >     turnRate = constant 0
  > instance HasLidar Robot where
  >     lidar i = tag i.seen ((scanOf 0 9[m] room) { seat = Vec2 { x = 0.1[m], y = 0 } })
  > room :: Array 360 Distance
  > room = generate (\k -> wall (toFloat k * 1[deg])) where
  >     wall a = if abs (angleDiff a 0) < 4[deg] then 0.5[m] else across a
  >     across a = if sin a > 0.01 then 1[m] / sin a else if sin a < -0.01 then -0.7[m] / sin a else 8[m]
  > main :: SF Robot (Distance, Distance, Distance, Int)
  > main = byLidar 0.2[m] (proc w -> (frontSonar w, sideSonar w, rightSonar w, echoes (sonars w)))
  > echoes :: Array 16 Sonar -> Int
  > echoes = foldl (\n s -> if isEvent s.echo then n + 1 else n) 0
  > FROB
  $ printf 'time,in.seen\n0,\n0.1,()\n0.2,\n0.3,()\n0.6,\n0.9,\n3,\n' | trace senses | cells | rounded
  5,5,5,0
  0.4,0.800008805,0.500135178,16
  0.4,0.800008805,0.500135178,0
  0.4,0.800008805,0.500135178,16
  0.4,0.800008805,0.500135178,0
  2.9875,3.16250385,3.03130914,0
  4.85862603,4.87091969,4.86170353,0
  $ single senses

The functions from which `byLidar` computes them. `seen` delivers objects only
at instants with a scan, and only objects within the range of the lidar:

  $ cat > parts.frob << 'FROB'
  > import Capability
  > import Geometry
  > import Lidar
  > data Robot = Robot { scan :: Event Distance }
  > instance HasOdometry Robot where
  >     robotPose _ = Pose { position = zeroVec, heading = 0 }
  >     velocity = constant 0
  >     turnRate = constant 0
  > instance HasLidar Robot where
  >     lidar i = mapE (\d -> scanOf 0 9[m] [d, 10[m], 2[m], 10[m]]) i.scan
  > main :: SF Robot ((Distance, Distance, Distance, Int), (Array 16 Bool, Array 4 (Event Distance)), Distance, Time)
  > main = proc i ->
  >     ( (frontByLidar 0.2[m] (seen i), besideByLidar 0.2[m] 1 (seen i), besideByLidar 0.2[m] (-1) (seen i), events (seen i).objects)
  >     , (map (\s -> isEvent s.echo) (sonarsByLidar i), ranges), lidarReach, lidarMemory ) where
  >     ranges = case lidar i of
  >         Event s -> objectRanges s
  >         NoEvent -> generate (const NoEvent)
  >     events = foldl (\n e -> if isEvent e then n + 1 else n) 0
  > FROB
  $ printf 'time,in.scan\n0,\n0.1,3\n0.2,\n' | trace parts | cells | rounded
  5,5,5,0,false,false,false,false,false,false,false,false,false,false,false,false,false,false,false,false,,,,,5,0.5
  2.8,1.04309305,1.04309305,18,true,true,true,false,false,false,true,true,true,true,true,false,false,false,true,true,3,,2,,5,0.5
  2.8,1.04309305,1.04309305,0,false,false,false,false,false,false,false,false,false,false,false,false,false,false,false,false,,,,,5,0.5
  $ single parts
