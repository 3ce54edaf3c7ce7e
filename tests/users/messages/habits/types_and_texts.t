Types before names, texts in other quotes, fields that are assigned.

  $ cat > typed.frob <<'FROB'
  > import Robot
  > 
  > Velocity speed = 0.3[m/s]
  > 
  > main = reactimateRobot (proc _ -> roMake (setVelTR speed 0))
  > FROB
  $ frobc check typed.frob
  $ sed 's/Velocity speed/speed/' typed.frob > cured.frob
  $ frobc check cured.frob

  $ cat > quotes.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (if buttonHeld 'drive' i then 0.3[m/s] else 0) 0))
  > FROB
  $ frobc check quotes.frob
  $ sed "s/'/\\"/g" quotes.frob > cured.frob
  $ frobc check cured.frob

  $ cat > open.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (if buttonHeld "drive i then 0.3[m/s] else 0) 0))
  > FROB
  $ frobc check open.frob
  $ sed 's/"drive/"drive"/' open.frob > cured.frob
  $ frobc check cured.frob

  $ cat > assigned.frob <<'FROB'
  > import Geometry
  > import Robot
  > 
  > home = zeroVec
  > home.x = 1[m]
  > 
  > main = reactimateTask (driveTo home)
  > FROB
  $ frobc check assigned.frob
  $ sed 's/^home = .*/home = zeroVec { x = 1[m] }/;/^home.x/d' assigned.frob > cured.frob
  $ frobc check cured.frob
