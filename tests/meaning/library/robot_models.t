The modules Behaviour, Driving and Motion, compared with independent implementations: steps of uneven
length, steps of length 0, and gaps.

  $ . ./models.sh
  $ cat > behaviours.frob << 'FROB'
  > import Behaviour
  > main :: SF (Float, Angle, Float[1/s], Float, Bool, Bool, Float) (Int, Int, Int, Int, Int)
  > main = proc (_, _, _, _, pressed, reset, _) ->
  >     ( cell (settled 0.05[s] layer), cell (sticky 0.1[s] layer), cell (sticky 0.2[s] (settled 0.03[s] layer))
  >     , cell (layer `over` low), tried ) where
  >     layer = onlyIf pressed 1
  >     low = onlyIf reset 2
  >     cell = fromMaybe (-9)
  >     tried = case runTask (retryBackoff 4 0.05[s] 0.15[s] (-1) attempt) (pressed, reset) of
  >         Left out -> out
  >         Right (Just _) -> 10
  >         Right Nothing -> 20
  > attempt :: Task (Bool, Bool) Int (Maybe ())
  > attempt = untilRight (proc (fails, succeeds) -> if succeeds then Right (Just ()) else if fails then Right Nothing else Left 0)
  > FROB
  $ models behaviours
  double.c.csv: 2000 values, 0 differ
  float.c.csv: 2000 values, 0 differ

A robot that follows the commands of three tasks exactly:

  $ cat > driving.frob << 'FROB'
  > import Driving
  > import Motion
  > import TestRobot
  > type Row = (Velocity, AngularVelocity, Bool)
  > main :: SF (Float, Angle, Float[1/s], Float, Bool, Bool, Float) (Row, Row, Row)
  > main = proc _ -> (ideal (turnTo 200[deg]) (), ideal (turnBy 450[deg]) (), ideal (forward 1.5[m]) ())
  > ideal :: Task Senses Motors Bool -> SF () Row
  > ideal task = proc () -> (v, omega, end /= Nothing) where
  >     pose = moved senses.pose (v, omega)
  >     (v, omega, end) = motorsOf task (senses { pose = pose, speed = delay 0 v, turning = delay 0 omega })
  > FROB
  $ models driving
  double.c.csv: 3600 values, 0 differ
  float.c.csv: 3600 values, 0 differ

The geometry of paths: the point at a distance along the path, the distance to the path, the next
stop, and the curvature of pure pursuit. Only rows without NaN are compared:

  $ cat > paths.frob << 'FROB'
  > import Geometry
  > import Motion
  > main :: SF (Float, Angle, Float[1/s], Float, Bool, Bool, Float) (Point2, Distance, Distance, Distance, Float[1/m])
  > main = proc (x, a, _, goal, _, _, _) -> (pathPoint legs s, off, nextStop legs s, whole, pursuitCurvature (hypot x goal * 1[m]) a) where
  >     legs = pathLegs (map at [(0, 0), (2, 0), (2, 1), (2, 1), (0.5, 1), (1.5, 1)])
  >     at (u, v) = Vec2 { x = u * 1[m], y = v * 1[m] }
  >     whole = pathLength legs
  >     s = 1.5[m] * (goal + 2)
  >     here = at (x, a)
  >     off = distance here (pathPoint legs (nearestAlong legs 0 whole here))
  > FROB
  $ models paths
  double.c.csv: 2328 values, 0 differ
  float.c.csv: 2328 values, 0 differ
