Trackers follow a square and its corner by their edges, while a robot drives and turns in front of
them. The results are compared with the positions computed from the camera's geometry: the root mean
square of the distances.

  $ export LC_ALL=C
  $ picture () { # BRIGHTNESS INSIDE, AROUND
  >   printf 'P5 96 96 255\n'
  >   awk -v inside=$1 -v around=$2 'BEGIN { for (y = 0; y < 96; y++) for (x = 0; x < 96; x++)
  >     printf "%c", (x >= 16 && x < 80 && y >= 16 && y < 80) ? inside : around }'
  > }
  $ picture 120 32 > bright.pgm; picture 32 120 > dark.pgm
  $ cat > shapes.frob << 'FROB'
  > import Geometry
  > import Pioneer
  > import Robot
  > import Tracking
  > import Vision
  > 
  > -- | A place in the world, in metres from where the robot began, and its height.
  > data Known = Known { away, left, up :: Distance }
  > 
  > -- | The robot began 3 degrees to the left.
  > seenFrom :: Lens -> Pose -> Known -> Vec2[px]
  > seenFrom l robot k = Vec2
  >     { x = l.centreX - l.focalX * there.y / depth
  >     , y = l.centreY - l.focalY * (k.up - l.up) / depth }
  >   where
  >     place = rotate (-3[deg]) (Vec2 { x = k.away, y = k.left })
  >     there = toFrame robot place
  >     depth = there.x - l.ahead
  > 
  > before :: Time -> Pose -> Velocity -> AngularVelocity -> Pose
  > before t p v w = Pose
  >     { position = p.position ^-^ polar (t * v) (p.heading - 0.5 * t * w), heading = p.heading - t * w }
  > 
  > -- | As a patch of the size of the square.
  > square :: Placement
  > square = Placement { x = 174.485[px], y = 102.614[px], angle = 0, scale = 1.37[px] }
  > 
  > param bright :: Bool = True
  > 
  > -- | The lower right corner: a segment across the right side, and one across the lower side.
  > corner :: Meeting
  > corner = Meeting { one = across 196 112 0, other = across 184 124 90[deg] } where
  >     across x y out = Segment
  >         { x = x * 1[px], y = y * 1[px], angle = if bright then out + 180[deg] else out
  >         , length = 16[px], width = 12[px] }
  > 
  > data Off = Off { square, corner, size :: Float[px] }
  > 
  > judge :: SF (Event Frame, Pose, Velocity, AngularVelocity) (Event Off)
  > judge = proc (frame, p, v, w) -> mapE off frame where
  >     whole  = squareTracker (if bright then Brighter else Darker) square frame
  >     meets  = cornerTracker corner frame
  >     off f  = Off
  >         { square = missed whole (seen (Known { away = 3.9[m], left = 0, up = 0.5[m] }))
  >         , corner = missed meets low
  >         , size = if whole.sight == Seen then 32 * whole.estimate.scale - norm (high ^-^ low) / sqrt 2 else 1000[px] }
  >       where
  >         low    = seen (Known { away = 3.9[m], left = -0.3[m], up = 0.2[m] })
  >         high   = seen (Known { away = 3.9[m], left = 0.3[m], up = 0.8[m] })
  >         seen k = seenFrom (lens f.image) (before f.age p v w) k
  > 
  > missed :: Tracked a => Track a -> Vec2[px] -> Float[px]
  > missed t truth = if t.sight == Seen then norm (middleOf t.estimate ^-^ truth) else 1000[px]
  > 
  > main = reactimateRobot (proc i ->
  >     roMake (setVelTR (speed i) (0.05[rad/s] * cos (1[1/s] * time ())))) where
  >     speed = proc i -> if cameraAlive 1[s] i then 0.1[m/s] else 0
  > 
  > judged :: SF PioneerInput (Event Off)
  > judged = proc i -> judge (camera i, robotPose i, velocity i, turnRate i)
  > FROB
  $ world () { # PICTURE
  >   cat <<END
  > [start]
  > x = 1
  > y = 2
  > heading_deg = 3
  > [camera]
  > noise = 4
  > blur = 1
  > [[poster]]
  > center = [4.9, 2]
  > facing_deg = 180
  > size = [0.9, 0.9]
  > middle = 0.5
  > picture = "$1"
  > [[wall]]
  > points = [[0, 0], [5, 0], [5, 4.5], [0, 4.5]]
  > closed = true
  > END
  > }
  $ judged () { # WORLD OPTIONS
  >   frobc run shapes.frob --world $1 --for 8s --record run.csv $2 $3 > summary
  >   frobc trace shapes.frob --entry judged --input run.csv $2 $3 > judged.csv
  >   awk 'BEGIN { FS = "[{},= ]+"; limit["square"] = '${most:-0.3}'; limit["corner"] = 0.5; limit["size"] = 1 }
  >     NF > 6 { if (!begun) { begun = 1; next } for (i = 3; i < NF; i += 2) { s[$i] += $(i + 1) ^ 2; n[$i]++ } }
  >     END { for (k in limit) print k, (n[k] > 230 && sqrt(s[k] / n[k]) < limit[k] ? "within " limit[k] : sqrt(s[k] / n[k])) }' judged.csv | sort
  > }
  $ world bright.pgm > bright.toml; judged bright.toml
  corner within 0.5
  size within 1
  square within 0.3
  $ frobc trace shapes.frob --entry judged --input run.csv --engine interp | cmp - judged.csv
  $ world dark.pgm > dark.toml; judged dark.toml --param bright=False
  corner within 0.5
  size within 1
  square within 0.3

If the upper left corner of the square is hidden, its position follows from the
others.

  $ picture 90 90 > grey.pgm
  $ { cat bright.toml; printf '[[poster]]\ncenter = [4.85, 2.3]\nfacing_deg = 180\nsize = [0.25, 0.25]\nmiddle = 0.8\npicture = "grey.pgm"\n'; } > hidden.toml
  $ most=0.6; judged hidden.toml
  corner within 0.5
  size within 1
  square within 0.6

A smoothed track follows with a delay, and restarts when the object is found again.

  $ cat > smooth.frob << 'FROB'
  > import Tracking
  > import Vision
  > 
  > main :: SF (Bool, Float[px]) (Float[px], Float[px])
  > main = proc (sees, x) -> (t.estimate.cx, t.estimate.box.x) where
  >     t = smoothTrack 0.3[s] (Track
  >         { sight = if sees then Seen else Lost, since = 0, residual = 0
  >         , estimate = noBlob { cx = x, box = Region { x = x - 5[px], y = 0, width = 10[px], height = 10[px] } } })
  > FROB
  $ printf '%s\n' time,in.1,in.2 0,true,10 0.1,true,10 0.2,true,20 0.3,true,20 0.4,true,20 0.5,false,50 0.6,true,80 0.7,true,90 > steps.csv
  $ frobc trace smooth.frob --input steps.csv
  time,out.1,out.2
  0.000000000,10,5
  0.100000000,10,5
  0.200000000,12.5,7.5
  0.300000000,14.375,9.375
  0.400000000,15.78125,10.78125
  0.500000000,50,45
  0.600000000,80,75
  0.700000000,82.5,77.5
