Motions, with an ideal robot: it follows its commands exactly. For their
behaviour with noise, on the robots of the library, see
tests/robots/run/motions.t.

  $ . ./trace.sh

The curvature of the arc to a point; the legs of a path, of which the third turns back and the
fourth has no length; points along it; the nearest one in a part of it:

  $ cat > paths.frob << FROB
  > import Geometry
  > import Motion
  > main :: SF (Distance, Distance) (Float[1/m], Distance, Point2, Distance, Distance, Distance, Point2)
  > main = proc (a, b) -> (pursuitCurvature a (90[deg]), pathLength legs, pathPoint legs a, nextStop legs a, nearest, nearestAlong legs 4.5[m] 5[m] p, onLeg a (legs ! 1)) where
  >     p = Vec2 { x = b, y = 1[m] }
  >     nearest = nearestAlong legs 0 (pathLength legs) p
  > legs :: Array 5 Leg
  > legs = pathLegs [zeroVec, spot 2 0, spot 2 2, spot 2 2, spot 2 0.5]
  > spot :: Float -> Float -> Point2
  > spot x y = Vec2 { x = x * 1[m], y = y * 1[m] }
  > FROB
  $ printf '%s\n' -1,-1 0,0 1,1 2,1.5 3,2 4,3 5,4 9,9 nan,nan | rows in.1,in.2 | trace paths 2>/dev/null | cells
  0,5.5,0,0,4,0,5,0,0
  0,5.5,0,0,4,0,5,0,0
  2,5.5,1,0,4,1,5,1,0
  1,5.5,2,0,4,3,5,2,0
  0.66666666666666663,5.5,2,1,4,3,5,2,0
  0.5,5.5,2,2,5.5,3,5,2,0
  0.40000000000000002,5.5,2,1,5.5,3,5,2,0
  0.22222222222222221,5.5,2,0.5,5.5,3,5,2,0
  0,5.5,0,0,5.5,0,4.5,nan,nan

A path of one point, and one whose points are all the same:

  $ cat > points.frob << FROB
  > import Geometry
  > import Motion
  > main :: SF Distance (Distance, Point2, Distance, Distance, Point2, Distance)
  > main = proc a -> (pathLength one, pathPoint one a, nearestAlong one 0 1[m] zeroVec, pathLength same, pathPoint same a, nextStop same 0) where
  >     one = pathLegs [Vec2 { x = 1[m], y = 2[m] }]
  >     same = pathLegs [Vec2 { x = 1[m], y = 2[m] }, Vec2 { x = 1[m], y = 2[m] }]
  > FROB
  $ printf '%s\n' -1 0 1 | rows in | trace points | cells
  0,1,2,0,0,1,2,0
  0,1,2,0,0,1,2,0
  0,1,2,0,0,1,2,0

The heading past obstacles: the desired one if it is clear, otherwise the next
one on the side to which the robot was already heading; none if there are points
all around:

  $ cat > headings.frob << FROB
  > import Geometry
  > import Motion
  > main :: SF (Distance, Distance, Angle) (Maybe Angle, Maybe Angle, Bool)
  > main = proc (x, y, before) -> (past [Just p, Nothing], past (generate ring :: Array 12 (Maybe Point2)), lane p) where
  >     p = Vec2 { x = x, y = y }
  >     past :: Array n (Maybe Point2) -> Maybe Angle
  >     past points = headingPast 0.4[m] points before 0 (Vec2 { x = 1[m], y = 0 })
  >     lane = inLane 0.4[m] avoidReach (polar 1 0)
  >     ring k = Just (polar 0.5[m] (30[deg] * toFloat k))
  > FROB
  $ printf '%s\n' 5,0,0 1.1,0,0 0.9,0,0.1 0.9,0,-0.1 0.9,0.3,0.1 0.2,-0.3,0 -0.3,0,0 nan,0,0 |
  >   rows in.1,in.2,in.3 | trace headings | cells | rounded
  Just 0,Nothing,false
  Just 0,Nothing,false
  Just 0.52359877559829882,Nothing,true
  Just (-0.52359877559829915),Nothing,true
  Just (-0.17453292519943275),Nothing,true
  Just 0.69813170079773179,Nothing,true
  Just 0,Nothing,false
  Just 0,Nothing,false

A robot that follows its commands exactly. `motorsOf` returns the commands of
each task, and how it ends:

  $ cat > ideal.frob << FROB
  > import Geometry
  > import Motion
  > import TestRobot
  > main :: SF Bool ((Point2, Maybe Bool), (Angle, Maybe Bool), (Pose, Maybe Bool))
  > main = proc _ -> ((followed.position, end), (turned.heading, done), (posed, there)) where
  >     (followed, end) = ideal (followPath pursuit [zeroVec, spot 2 0, spot 2 2]) ()
  >     (turned, done) = ideal (turnTo 200[deg]) ()
  >     (posed, there) = ideal (goToPose Pose { position = spot 1 1, heading = 90[deg] }) ()
  > ideal :: Task Senses Motors Bool -> SF () (Pose, Maybe Bool)
  > ideal task = proc () -> (pose, end) where
  >     (v, omega, end) = motorsOf task (senses { pose = pose })
  >     pose = moved senses.pose (delay (0, 0) (v, omega))
  > spot :: Float -> Float -> Point2
  > spot x y = Vec2 { x = x * 1[m], y = y * 1[m] }
  > FROB
  $ awk 'BEGIN { print "time,in"; for (k = 0; k <= 1000; k++) printf "%.2f,false\n", k / 50 }' > ideal.csv
  $ last () { tail -n 1 | tr , '\n' | sed 1d | awk '/^-?[0-9]/ { $0 = sprintf("%.2f", $0) } { print }' | xargs; }
  $ trace ideal < ideal.csv | last
  2.00 1.90 Just true -2.76 Just true 1.00 0.95 1.54 Just true
  $ frobc trace ideal.frob --real float --input ideal.csv | last
  2.00 1.90 Just true -2.76 Just true 1.00 0.95 1.54 Just true

Each task ends because of an object in the robot's way, or because the robot is
stuck. A path that leads back to its start is driven completely, and an invalid
setting counts as the smallest valid one:

  $ cat > ends.frob << FROB
  > import Capability
  > import Driving
  > import Geometry
  > import Motion
  > import Past
  > import TestRobot
  > import Trial
  > 
  > path :: Array 2 Point2
  > path = [zeroVec, Vec2 { x = 2[m], y = 0 }]
  > 
  > -- | How a task ends for a robot that does not move.
  > still :: Task Senses Motors Bool -> SF Senses (Maybe Bool)
  > still task = proc i -> end where
  >     (_, _, end) = motorsOf task i
  > 
  > -- | The position and the result of a robot that follows its commands exactly.
  > ideal :: Task Senses Motors Bool -> SF () (Point2, Maybe Bool)
  > ideal task = proc () -> (pose.position, end) where
  >     (v, omega, end) = motorsOf task (senses { pose = pose })
  >     pose = moved senses.pose (delay (0, 0) (v, omega))
  > 
  > test "a path ends with False before an obstacle" = during 0.1[s] (proc () ->
  >     still (followPath pursuit path) (senses { ahead = 0.2[m] }) == (if time () > 0 then Just False else Nothing))
  > 
  > test "a path ends with False at a bump" = during 0.1[s] (proc () ->
  >     still (followPath pursuit path) (senses { hitOnLeft = True }) == (if time () > 0 then Just False else Nothing))
  > 
  > test "a path, a pose and a turn end with False if the robot is stuck" = during 2[s] (proc () -> so where
  >     late = if time () >= 1.05[s] then Just False else Nothing
  >     on = still (followPath pursuit path) senses
  >     to = still (goToPose Pose { position = path ! 1, heading = 0 }) senses
  >     turn = still (turnTo 90[deg]) senses
  >     so = time () > 0.9[s] && time () < 1.1[s] || on == late && to == late && turn == late)
  > 
  > test "a square is driven whole" = during 40[s] (proc () -> so where
  >     square = [zeroVec, Vec2 { x = 1[m], y = 0 }, Vec2 { x = 1[m], y = 1[m] }, Vec2 { x = 0, y = 1[m] }, zeroVec]
  >     (p, end) = ideal (followPath (pursuit { lookAhead = 0.2[m] }) square) ()
  >     beyond = ever (distance p (Vec2 { x = 1[m], y = 1[m] }) < 0.2[m])
  >     so = max (verdict (end == Nothing || beyond && norm p < 0.11[m])) (by 30[s] (end == Just True)))
  > 
  > test "bad settings count as the least ones" = during 110[s] (proc () -> by 105[s] (end == Just True) where
  >     nan = 0[m] / 0
  >     backwards v = -v * 1[m/s]
  >     (_, end) = ideal (followPath Pursuit { lookAhead = nan, speed = backwards 1, tolerance = -nan } path) ())
  > 
  > test "a pose of NaN for an instant stops the robot for that instant" = during 20[s] (proc () -> by 15[s] (end == Just True) where
  >     nan = 0[m] / 0
  >     lost = isEvent (every 1[s] ())
  >     (v, omega, end) = motorsOf (followPath pursuit path) (senses { pose = if lost then pose { position = Vec2 { x = nan, y = nan } } else pose })
  >     pose = moved senses.pose (delay (0, 0) (if lost then (0, 0) else (v, omega)))
  >     assert "commands nothing that is a number" (not lost || end /= Nothing || not (v == v)))
  > 
  > test "a speed and a turn rate are never too high" = during 12[s] (proc () -> so where
  >     (v, omega, _) = motorsOf (followPath (pursuit { speed = 0.5[m/s] }) [zeroVec, Vec2 { x = 1[m], y = 0 }, Vec2 { x = 1[m], y = 1[m] }]) (senses { pose = pose })
  >     pose = moved senses.pose (delay (0, 0) (v, omega))
  >     so = v >= 0 && v <= 0.5[m/s] && abs omega <= turnSpeed + 1e-6[1/s])
  > 
  > test "stuck counts only while it is commanded" = during 4[s] (proc () -> so where
  >     commanded = time () > 2[s]
  >     is = stuckWhile (commanded, senses)
  >     now = time ()
  >     so = if is then now > 2.9[s] else now < 3.2[s])
  > 
  > test "recovers twice, then gives up" = during 60[s] (proc () -> so where
  >     -- the task fails after 1 s each time; the robot cannot leave its place
  >     fails = mkTask (proc _ -> (restingOutput, tag (after 1[s] ()) False))
  >     end = still (recover 2 fails) senses
  >     never = still (recover 0 fails) senses
  >     -- 1 s, and twice: 1 s stuck going back, 1 s turning, 1 s going on, and 1 s for the task
  >     now = time ()
  >     so = (abs (now - 9[s]) < 0.4[s] || (end == Nothing) == (now < 9[s]))
  >         && never == (if now >= 1[s] then Just False else Nothing))
  > 
  > test "wanders ahead, and turns before an obstacle to the side with more room" = during 0.9[s] (proc () -> so where
  >     near = time () > 0.5[s]
  >     (v, omega, _) = motorsOf wander (senses { ahead = if near then 0.3[m] else 5[m], onLeft = 1[m], onRight = 2[m] })
  >     so = if near then v == 0 && omega \`about\` (-turnSpeed) else v \`about\` driveSpeed && omega == 0)
  > 
  > test "backs off after a bump" = during 0.9[s] (proc () -> so where
  >     (v, _, _) = motorsOf wander (senses { hitOnLeft = time () > 0.5[s] })
  >     now = time ()
  >     so = if now > 0.55[s] then v < 0 else now > 0.45[s] || v > 0)
  > 
  > test "steps aside: back, to the left, ahead" = during 12[s] (proc () -> so where
  >     (p, end) = ideal (sidestep 1) ()
  >     so = max (verdict (end == Nothing || abs (p.x - 0.05[m]) < 0.04[m] && abs (p.y - 0.43[m]) < 0.03[m])) (by 11[s] (end == Just True)))
  > 
  > test "ends at once with the side that has more room" = during 0.1[s] (proc () -> so where
  >     (_, _, left) = motorsOf roomier (senses { onLeft = 2[m], onRight = 1[m] })
  >     (_, _, right) = motorsOf roomier (senses { onLeft = 1[m], onRight = 2[m] })
  >     so = left == Just 1 && right == Just (-1))
  > 
  > test "strolls until something is near or it bumps, and then turns until the way is free" = during 0.9[s] (proc () -> so where
  >     now = time ()
  >     late = now > 0.5[s]
  >     near = still stroll (senses { ahead = if late then 0.3[m] else 1[m] })
  >     bump = still stroll (senses { hitOnLeft = late })
  >     (_, omega, free) = motorsOf (turnAside 0.2[s] 1) (senses { ahead = if late then 1[m] else 0.3[m] })
  >     (_, _, soon) = motorsOf (turnAside 0.2[s] 1) senses
  >     so = near == (if late then Just False else Nothing) && bump == (if late then Just True else Nothing)
  >         && free == (if late then Just () else Nothing) && omega == (if late then 0 else turnSpeed)
  >         && soon == (if now >= 0.2[s] then Just () else Nothing))
  > FROB
  $ frobc test ends.frob
  ok    a path ends with False before an obstacle: 0.1 s
  ok    a path ends with False at a bump: 0.1 s
  ok    a path, a pose and a turn end with False if the robot is stuck: 2 s
  ok    a square is driven whole: 40 s
  ok    bad settings count as the least ones: 110 s
  ok    a pose of NaN for an instant stops the robot for that instant: 20 s
  ok    a speed and a turn rate are never too high: 12 s
  ok    stuck counts only while it is commanded: 4 s
  ok    recovers twice, then gives up: 60 s
  ok    wanders ahead, and turns before an obstacle to the side with more room: 0.9 s
  ok    backs off after a bump: 0.9 s
  ok    steps aside: back, to the left, ahead: 12 s
  ok    ends at once with the side that has more room: 0.1 s
  ok    strolls until something is near or it bumps, and then turns until the way is free: 0.9 s
  14 tests: all hold
  $ frobc test ends.frob --real float | tail -n 1
  14 tests: all hold

The limits:

  $ cat > limits.frob << FROB
  > import Motion
  > main :: SF () (Distance, Distance, Time)
  > main = proc _ -> (progressAfter, avoidReach, avoidMemory)
  > FROB
  $ printf 'time\n0\n' | frobc trace limits.frob --input - | cells
  1,1,1.5

The examples in the doc comments compile: tasks, and signal functions of a robot's input:

  $ awk '
  >     /^-- Example of a task: `.*`\.$/ { gsub(/^[^`]*`|`\.$/, ""); tasks = tasks "    (" $0 ") `timeOut` 30[s]\n"; n++ }
  >     /^-- Example on a robot: `.*`\.$/ { gsub(/^[^`]*`|`\.$/, ""); tasks = tasks "    ask (proc i -> " $0 ")\n"; n++ }
  >     END {
  >         printf "import Behaviour\nimport Driving\nimport Geometry\nimport Imu\nimport Lidar\nimport Motion\nimport Robot\n"
  >         print "goal :: Point2\ngoal = Vec2 { x = 1[m], y = 1[m] }"
  >         print "main :: (HasSonarRing i, HasLidar i, HasImu i, DiffDrive o) => Program i o"
  >         printf "main = reactimateTask (watching (do\n%s    return ()))\n", tasks
  >         print n " examples" > "/dev/stderr"
  >     }' ../../../stdlib/*.frob > examples.frob
  30 examples
  $ frobc check --robot pioneer examples.frob && frobc check --robot scout examples.frob
