The module Driving: its constants, and the functions that the trials of robots use only indirectly.

  $ . ./trace.sh
  $ cat > constants.frob << 'FROB'
  > import Driving
  > main :: SF Int (Array 4 Distance, (Angle, Angle, Time), (Velocity, AngularVelocity, Float[1/s]))
  > main = proc _ ->
  >     ( [placeRadius, blockedAt, standsWithin, wayEnd], (turnsWithin, turnEnd, stuckAfter)
  >     , (driveSpeed, turnSpeed, turnGain) )
  > FROB
  $ echo 0 | rows in | trace constants | cells | rounded
  0.15,0.3,0.01,0.02,0.0174532925,0.034906585,1,0.3,1.04719755,2

How long a condition has held, where a step counts for at most 0.1 s, and a task that ends with the
position of the robot:

  $ cat > held.frob << 'FROB'
  > import Driving
  > import Geometry
  > import TestRobot
  > main :: SF (Bool, Distance) (Time, Either () Distance)
  > main = proc (b, x) -> (heldTime b, runTask (mapT (\p -> p.x) robotPlace) (at x)) where
  >     at d = senses { pose = Pose { position = Vec2 { x = d, y = 0 }, heading = 0 } }
  > FROB
  $ cat > held.csv << ROWS
  > time,in.1,in.2
  > 0,true,1
  > 0.05,true,2
  > 5,true,3
  > 5,true,4
  > 5.25,false,5
  > 5.5,true,6
  > ROWS
  $ trace held < held.csv | rounded
  time,out.1,out.2
  0,0,Right 1
  0.05,0.05,Right 1
  5,0.15,Right 1
  5,0.15,Right 1
  5.25,0,Right 1
  5.5,0.1,Right 1
  $ single held
