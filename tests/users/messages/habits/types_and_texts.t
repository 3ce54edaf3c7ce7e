Types before names, texts in other quotes, fields that are assigned.

  $ cat > typed.frob <<'FROB'
  > import Robot
  > 
  > Velocity speed = 0.3[m/s]
  > 
  > main = reactimateRobot (proc _ -> roMake (setVelTR speed 0))
  > FROB
  $ frobc check typed.frob
  error[E0226]: a top-level definition defines one name, not a pattern
   --> typed.frob:3:1
    |
  3 | Velocity speed = 0.3[m/s]
    | ^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: write `speed = …`; to declare its type, write `speed :: Velocity` on the line above
  
  1 error
  [1]
  $ sed 's/Velocity speed/speed/' typed.frob > cured.frob
  $ frobc check cured.frob

  $ cat > quotes.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (if buttonHeld 'drive' i then 0.3[m/s] else 0) 0))
  > FROB
  $ frobc check quotes.frob
  error[E0103]: unexpected character `'`
   --> quotes.frob:3:67
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR (if buttonHeld 'drive' i then 0.3[m/s] else 0) 0))
    |                                                                   ^
    |
    = hint: put text in double quotes: `"drive"`
  
  1 error
  [1]
  $ sed "s/'/\"/g" quotes.frob > cured.frob
  $ frobc check cured.frob

  $ cat > open.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (if buttonHeld "drive i then 0.3[m/s] else 0) 0))
  > FROB
  $ frobc check open.frob
  error[E0104]: this string is not closed on its line
   --> open.frob:3:67
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR (if buttonHeld "drive i then 0.3[m/s] else 0) 0))
    |                                                                   ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: end the string with another `"` on the same line
  
  1 error
  [1]
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
  error[E0114]: a field access cannot be part of a pattern
   --> assigned.frob:5:1
    |
  5 | home.x = 1[m]
    | ^^^^^^
    |
    = hint: Frob has no assignments: make a changed copy with a new name, as in `changed = home { x = … }`
  
  1 error
  [1]
  $ sed 's/^home = .*/home = zeroVec { x = 1[m] }/;/^home.x/d' assigned.frob > cured.frob
  $ frobc check cured.frob
