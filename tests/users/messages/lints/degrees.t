Numbers of degrees used where angles are in radians: compared with an angle, added to one, passed as
one. Also through the name of an equation, and with the factor 57.3.

  $ cat > degrees.frob <<'FROB'
  > import Geometry
  > 
  > looksAside :: SF Pose Bool
  > looksAside = proc pose -> pose.heading * 180 / pi > 90[deg]
  > 
  > past :: SF (Pose, Angle) (Bool, Float)
  > past = proc (pose, goal) -> (goal < d, d - far) where
  >     d   = 57.3 * pose.heading
  >     far = 100[deg]
  > 
  > main :: SF (Pose, Angle, AngularVelocity) (Bool, (Bool, Float), Float, Bool)
  > main = proc (pose, goal, turn) -> (looksAside pose, past (pose, goal), sin h, fast) where
  >     h    = pose.heading / 1[deg]
  >     fast = turn * (180 / pi) >= 45[deg/s]
  > FROB
  $ frobc check degrees.frob
  warning[W0313]: this is in degrees, but angles are in radians
   --> degrees.frob:4:27
    |
  4 | looksAside = proc pose -> pose.heading * 180 / pi > 90[deg]
    |                           ^^^^^^^^^^^^^^^^^^^^^^^   ------- `90[deg]` is in radians
    |
    = hint: remove the conversion, because `90[deg]` is in radians too: write `pose.heading`
  
  warning[W0313]: this is in degrees, but angles are in radians
   --> degrees.frob:7:37
    |
  7 | past = proc (pose, goal) -> (goal < d, d - far) where
    |                              ----   ^
    |                              |
    |                              `goal` is in radians
    |
    = hint: remove the conversion, because `90[deg]` is in radians too: write `pose.heading`
  
  warning[W0313]: this is in degrees, but angles are in radians
   --> degrees.frob:7:40
    |
  7 | past = proc (pose, goal) -> (goal < d, d - far) where
    |                                        ^   --- `far` is in radians
    |
    = hint: remove the conversion, because `90[deg]` is in radians too: write `pose.heading`
  
  warning[W0313]: this is in degrees, but angles are in radians
    --> degrees.frob:12:76
     |
  12 | main = proc (pose, goal, turn) -> (looksAside pose, past (pose, goal), sin h, fast) where
     |                                                                            ^
     |
     = hint: remove the conversion, because `90[deg]` is in radians too: write `pose.heading`
  
  warning[W0313]: this is in degrees, but angles are in radians
    --> degrees.frob:14:12
     |
  14 |     fast = turn * (180 / pi) >= 45[deg/s]
     |            ^^^^^^^^^^^^^^^^^    --------- `45[deg/s]` is in radians
     |
     = hint: remove the conversion, because `90[deg]` is in radians too: write `turn`
  
  5 warnings

Numbers of degrees that are used as such, and numbers that are converted back to an angle.

  $ cat > numbers.frob <<'FROB'
  > import Geometry
  > 
  > main :: SF (Pose, Angle, Float) (Bool, Bool, Bool, Bool, Float, Float, Float)
  > main = proc (pose, goal, x) -> (d < 90, h < 90[deg], d < goal / 1[deg], again < goal, fast, slow, up) where
  >     h     = pose.heading
  >     d     = h * 180 / pi
  >     again = d * 1[deg] + d * pi / 180
  >     fast  = sin (57.3 / x)
  >     slow  = sin (57 * x)
  >     up    = 180 / pi + goal
  > FROB
  $ frobc check numbers.frob
