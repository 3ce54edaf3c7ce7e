Fields of another record, fields as values, units of computed values.

  $ cat > rgb.frob <<'FROB'
  > import Robot
  > import Vision
  > red = ColourRange { r = 255, g = 0, b = 0 }
  > main = reactimateRobot (proc i -> roMake (setVelTR 0 0.1[rad/s]) where
  >     n = mapE (\f -> (findBlob f.image (everywhere f.image) red).pixels) (camera i))
  > FROB
  $ frobc check rgb.frob
  error[E0209]: constructor `ColourRange` has no fields `r`, `g` and `b`
    --> rgb.frob:3:21
     |
   3 | red = ColourRange { r = 255, g = 0, b = 0 }
     |                     ^
     |
    ::: stdlib/Vision.frob:44:20
     |
  44 | data ColourRange = ColourRange
     |                    ----------- declared here
     |
     = hint: its fields are `ColourRange { hueFrom = …, hueTo = …, saturationFrom = …, saturationTo = …, valueFrom = …, valueTo = … }`
  
  1 error
  [1]

  $ cat > judge.frob <<'FROB'
  > import Robot
  > import Trial
  > import WallFollow
  > main = reactimateRobot (wallFollow1 0.3[m])
  > trial "keeps off" = Trial { world = "room.toml", lasts = 60[s], seeds = 1 `to` 5, judge = not touches }
  > FROB
  $ frobc check judge.frob
  error[E0205]: unknown name `touches`
   --> judge.frob:5:95
    |
  5 | trial "keeps off" = Trial { world = "room.toml", lasts = 60[s], seeds = 1 `to` 5, judge = not touches }
    |                                                                                               ^^^^^^^
    |
    = note: `touches` is a field of `Truth`: write `r.touches`, or `\r -> r.touches` if you need a function, or `proc r -> r.touches` if you need a signal function
  
  1 error
  [1]

  $ cat > unit.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = (0.5 * frontSonar i)[m/s])
  > FROB
  $ frobc check unit.frob
  error[E0205]: a unit can only follow a literal number or a type, not a computed value
   --> unit.frob:3:29
    |
  3 |     v = (0.5 * frontSonar i)[m/s])
    |                             ^^^^^
    |
    = hint: a value already has its unit; to give a plain number a unit, multiply: `x * 1[m/s]`
  
  1 error
  [1]

  $ cat > as.frob <<'FROB'
  > deg :: Angle -> Float
  > deg a = a as deg
  > main :: SF Angle Float
  > main = proc a -> deg a
  > FROB
  $ frobc check as.frob
  error[E0205]: unknown name `as`
   --> as.frob:2:11
    |
  2 | deg a = a as deg
    |           ^^
    |
    = hint: to get a plain number, divide by the unit: `x / 1[deg]`
  
  1 error
  [1]

  $ cat > dt.frob <<'FROB'
  > main :: SF Velocity Distance
  > main = proc v -> integral v dt
  > FROB
  $ frobc check dt.frob
  error[E0205]: unknown name `dt`
   --> dt.frob:2:29
    |
  2 | main = proc v -> integral v dt
    |                             ^^
    |
    = hint: use `integral x` or `derivative x`, which need no time step; `stepTime ()` from `Control` returns the time since the previous instant
  
  1 error
  [1]
