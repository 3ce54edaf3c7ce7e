Records, instances and parameters that lack something.

A field:

  $ cat > field.frob <<'FROB'
  > import Geometry
  > import Robot
  > 
  > home :: Pose
  > home = Pose { position = zeroVec }
  > 
  > main = reactimateTask (driveTo home.position)
  > FROB
  $ frobc check field.frob
  error[E0228]: this `Pose` is missing the field `heading`
    --> field.frob:5:8
     |
   5 | home = Pose { position = zeroVec }
     |        ^^^^^^^^^^^^^^^^^^^^^^^^^^^
     |
    ::: stdlib/Geometry.frob:19:13
     |
  19 | data Pose = Pose { position :: Point2, heading :: Angle }
     |             ---- declared here
     |
     = hint: give every field a value: add `heading = …`
  
  1 error
  [1]
  $ sed 's/zeroVec/&, heading = 0/' field.frob > cured.frob
  $ frobc check cured.frob

A method:

  $ cat > method.frob <<'FROB'
  > import Robot
  > 
  > class Planner p where
  >     nextSpeed :: p -> Distance -> Velocity
  >     done :: p -> Bool
  > 
  > data Lazy = Lazy
  > 
  > instance Planner Lazy where
  >     nextSpeed _ d = 0.1[1/s] * d
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (nextSpeed Lazy (frontSonar i)) 0))
  > FROB
  $ frobc check method.frob
  error[E0363]: the instance `Planner Lazy` does not define `done`
   --> method.frob:9:10
    |
  5 |     done :: p -> Bool
    |             --------- `done` has no default
  ...
  9 | instance Planner Lazy where
    |          ^^^^^^^^^^^^
    |
    = hint: below the `where` of the instance, define `done = …`
  
  1 error
  [1]
  $ sed 's/    nextSpeed _ d.*/&\n    done _ = False/' method.frob > cured.frob
  $ frobc check cured.frob

A parameter that follows from another:

  $ cat > parameter.frob <<'FROB'
  > import Robot
  > 
  > param speed :: Velocity = 0.3[m/s]
  > param half :: Velocity = speed / 2
  > 
  > main = reactimateRobot (proc _ -> roMake (setVelTR half 0))
  > FROB
  $ frobc check parameter.frob
  error[E0391]: the value of the parameter `half` must be known before the run
   --> parameter.frob:4:26
    |
  4 | param half :: Velocity = speed / 2
    |                          ^^^^^^^^^
    |
    = note: it depends on the parameter `speed`, which can be set for each run
    = hint: define it without `param`: `half = …`
  
  1 error
  [1]
  $ sed 's/param half :: Velocity/half/' parameter.frob > cured.frob
  $ frobc check cured.frob
