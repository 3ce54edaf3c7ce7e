A tag moves through the picture as a robot turns: the tracker stays on the one of two tags with the
same number, and the corners are at the positions computed from the camera's geometry.

  $ cat > tagged.toml << 'TOML'
  > [start]
  > x = 0
  > y = 0
  > [camera]
  > noise = 4
  > dropout = 0.1
  > [[tag]]
  > id = 2
  > center = [1.2, 0.1]
  > facing_deg = 180
  > size = 0.2
  > [[tag]]
  > id = 2
  > center = [2.2, -0.4]
  > facing_deg = 180
  > size = 0.2
  > TOML
  $ cat > follow.frob << 'FROB'
  > import Geometry
  > import Pioneer
  > import Robot
  > import Tags
  > import Tracking
  > import Vision
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR 0 (omega i))) where
  >     omega = proc i -> if hold False (mapE (\_ -> True) (tags i)) then 0.2[rad/s] * cos (1[1/s] * now) else 0 where
  >         now = time ()
  > 
  > -- | The tag is printed 4 mm before its middle; its corners are 10 cm to each side of it.
  > seenFrom :: Lens -> Pose -> Distance -> Distance -> Vec2[px]
  > seenFrom l robot left up = Vec2
  >     { x = l.centreX - l.focalX * there.y / depth, y = l.centreY - l.focalY * (up - l.up) / depth }
  >   where
  >     there = toFrame robot (Vec2 { x = 1.196[m], y = left })
  >     depth = there.x - l.ahead
  > 
  > judged :: SF PioneerInput (Event (Sight, Float[px]))
  > judged = proc i -> mapE (off (tagTracker 2 (tags i)) (robotPose i) (turnRate i)) (tags i) where
  >     off t p w f = (t.sight, norm (t.estimate.corners ! 0 ^-^ corner)) where
  >         before = p { heading = p.heading - w * f.age }
  >         corner = seenFrom f.lens before 0.2[m] 0.4[m]
  > FROB
  $ frobc run follow.frob --world tagged.toml --for 8s --seed 1 --record run.csv > summary
  $ frobc trace follow.frob --entry judged --input run.csv > judged.csv
  $ frobc trace follow.frob --entry judged --input run.csv --engine interp | cmp - judged.csv
  $ sed 's/.*"(\(.*\))"/\1/' judged.csv | awk -F, '$1 == "Seen" { n++; s += $2 ^ 2; if ($2 > most) most = $2 } /Lost|Predicted/ { others++ }
  >   END { print (n > 205), others + 0, sqrt(s / n) < 0.5 ? "RMS within 0.5 px" : sqrt(s / n), most < 2 ? "each within 2 px" : most }'
  1 0 RMS within 0.5 px each within 2 px
