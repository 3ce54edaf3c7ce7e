The host looks for tags; the tags that it finds are an input of the program. Two tags on a wall, of
which the nearer one is larger; a robot in front of them computes their positions.

  $ cat > world.toml <<'TOML'
  > robot = "pioneer"
  > [start]
  > x = 0
  > y = 0
  > heading_deg = 10
  > [camera]
  > noise = 2
  > rate = 25
  > [[tag]]
  > id = 3
  > center = [1.5, 0.3]
  > facing_deg = 200
  > size = 0.2
  > middle = 0.4
  > [[tag]]
  > id = 7
  > center = [2, 0.8]
  > facing_deg = 190
  > size = 0.2
  > TOML
  $ cat > sees.frob <<'FROB'
  > import Capability
  > import Geometry
  > import Robot
  > import Tags
  > 
  > main :: (HasTags i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (wanted i) 0)) where
  >     wanted = proc i -> 0[1/s] * hold 0 (mapE (\f -> far (tagOf 3 f)) (tags i))
  >     far t = maybe 0 (\x -> x.margin * 1[m]) t
  > 
  > -- | How far a tag is from where it should be: ahead, to the left, up, and in degrees.
  > data Off = Off { id :: Int, x, y, up :: Distance, turned :: Float }
  > 
  > off :: (HasTags i, HasOdometry i) => SF i (Event (Maybe Off, Maybe Off, Int))
  > off = proc i -> mapE (\f -> (one f 3 a, one f 7 b, foldl count 0 f.found)) (tags i) where
  >     a = Pose { position = Vec2 { x = 1.5[m], y = 0.3[m] }, heading = 200[deg] }
  >     b = Pose { position = Vec2 { x = 2[m], y = 0.8[m] }, heading = 190[deg] }
  >     count n t = n + maybe 0 (\_ -> 1) t
  >     one f number at = case tagOf number f of
  >         Just t -> maybe Nothing (\p -> Just (from number at p)) (tagPose f.lens 0.2[m] t)
  >         Nothing -> Nothing
  >     from number at p = let
  >         robot = Pose { position = zeroVec, heading = 10[deg] }
  >         true' = compose (inverse robot) at
  >       in Off
  >         { id = number, x = p.pose.position.x - true'.position.x
  >         , y = p.pose.position.y - true'.position.y
  >         , up = p.height - (if number == 3 then 0.4[m] else 0.5[m])
  >         , turned = angleDiff p.pose.heading true'.heading / 1[deg] }
  > FROB
  $ frobc run sees.frob --world world.toml --for 2s --seed 1 --record log.csv > summary
  $ head -1 log.csv | tr , '\n' | grep tags
  in.console.camera tags
  $ ls log.frames 2>&1 | grep -c .ppm
  0
  [1]

Over 50 frames, no tag is ever missed, off by more than 2 cm, or turned by more than 5 degrees.

  $ frobc trace sees.frob --entry off --robot pioneer --input log.csv > off.csv
  $ cat > worst.awk << 'AWK'
  > BEGIN { FS = "[{},= ()\"]+" }
  > /Just/ { n++; for (i = 1; i < NF; i++) {
  >     if ($i ~ /^(x|y|up)$/ && ($(i + 1) ^ 2) > place) place = $(i + 1) ^ 2
  >     if ($i == "turned" && ($(i + 1) ^ 2) > angle) angle = $(i + 1) ^ 2 } all += $(NF - 1) }
  > END { print n, "frames,", all, "tags;", sqrt(place) < 0.02 ? "within 2 cm" : sqrt(place), sqrt(angle) < 5 ? "within 5 degrees" : sqrt(angle) }
  > AWK
  $ awk -f worst.awk off.csv
  51 frames, 102 tags; within 2 cm within 5 degrees

Both engines have the same results, also in single precision. The tag finder need not be installed.

  $ mkdir broken; : > broken/libapriltag.so.3
  $ LD_LIBRARY_PATH=$PWD/broken frobc trace sees.frob --entry off --robot pioneer --input log.csv | cmp - off.csv
  $ frobc trace sees.frob --entry off --robot pioneer --input log.csv --engine interp | cmp - off.csv
  $ frobc trace sees.frob --entry off --robot pioneer --input log.csv --real float > float.csv
  $ frobc trace sees.frob --entry off --robot pioneer --input log.csv --real float --engine interp | cmp - float.csv
  $ awk -f worst.awk float.csv
  51 frames, 102 tags; within 2 cm within 5 degrees

The tag finder is missing although it is needed; a program without tags does not
need it.

  $ LD_LIBRARY_PATH=$PWD/broken frobc run sees.frob --world world.toml --for 1s
  error: this program detects tags, but the library libapriltag.so.3 is not installed: install it (Debian: `sudo apt-get install libapriltag-dev`); replaying a recording does not need it
  [2]
  $ cat > rests.frob <<'FROB'
  > import Pioneer
  > import Robot
  > 
  > main = reactimateRobot atRest
  > FROB
  $ LD_LIBRARY_PATH=$PWD/broken frobc run rests.frob --world world.toml --for 1s | head -1
  time simulated: 1.000 s

A program may examine the same frames itself. A world without a camera; a robot; the report.

  $ cat > both.frob <<'FROB'
  > import Robot
  > import Tags
  > import Vision
  > 
  > main :: (HasTags i, HasCamera i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (gap i) 0)) where
  >     gap = proc i -> 0.1[m/s] * toFloat (hold 0 (numbers (camera i) (tags i)))
  >     numbers c t = case (c, t) of
  >         (Event f, Event g) -> Event (f.number - g.number)
  >         (NoEvent, NoEvent) -> NoEvent
  >         _ -> Event 1
  > FROB
  $ frobc run both.frob --world world.toml --for 1s --seed 1 | grep driven
  distance driven: 0.000 m
  $ frobc report both.frob --robot pioneer | grep -E '^ *camera'
    camera       camera    both.frob:7
    camera tags    tags    both.frob:7
  $ sed '/^.camera/d; /^noise/d; /^rate/d' world.toml > dark.toml
  $ frobc run sees.frob --world dark.toml --for 1s
  error: the program uses a camera, `camera`, but the robot in this world has no camera: add a table [camera] to the world file
  [2]
  $ frobc build sees.frob --robot pioneer -o sees
  $ frobc build sees.frob --robot pioneer --target cortex-m -o sees
  error: sees uses the camera `camera`, but cameras are available only in the simulator and on Linux robots, not on boards
  [2]

Two controls of a console with the same label, one of which is a camera's tags.

  $ cat > twice.frob <<'FROB'
  > import Capability
  > import Robot
  > import Tags
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (if isEvent (tags i) || buttonHeld "camera tags" i then 0 else 1[m/s]) 0))
  > FROB
  $ frobc check twice.frob 2>&1 | head -1
  error[E0442]: the console already has another control with the label `camera tags`
