Hints that contain the program's own code, ready to paste.

A mode where a function that returns the next mode is expected:

  $ cat > mode.frob <<'FROB'
  > main :: SF Float Float
  > main = switch (proc x -> (x, when (x > 1))) rest
  > 
  > rest :: SF Float Float
  > rest = proc x -> 2 * x
  > FROB
  $ frobc check mode.frob 2>&1 | grep hint
    = hint: write a function that ignores its argument: `(\_ -> rest)`
  $ sed 's/)) rest/)) (\\_ -> rest)/' mode.frob > cured.frob
  $ frobc check cured.frob

A pose has the field `heading`, whatever its name elsewhere:

  $ cat > pose.frob <<'FROB'
  > import Geometry
  > import Robot
  > 
  > main :: SF RobotInput Angle
  > main = proc i -> p.theta where
  >     p = robotPose i
  > FROB
  $ frobc check pose.frob 2>&1 | grep hint
    = hint: write `p.heading`
  $ sed 's/p.theta/p.heading/' pose.frob > cured.frob
  $ frobc check cured.frob

A parameter for each coordinate of a point:

  $ cat > goal.frob <<'FROB'
  > import Geometry
  > 
  > param goal :: Point2 = Vec2 { x = 1[m], y = 0 }
  > 
  > main :: SF () Point2
  > main = proc () -> goal
  > FROB
  $ frobc check goal.frob 2>&1 | grep hint
    = hint: declare a parameter for each number, `param goalX :: Float[m] = 0[m]`, `param goalY :: Float[m] = 0[m]`, and write `goal = Vec2 { x = goalX, y = goalY }`
  $ sed 's/^param.*/param goalX :: Float[m] = 0[m]\nparam goalY :: Float[m] = 0[m]\ngoal = Vec2 { x = goalX, y = goalY }/' goal.frob > cured.frob
  $ frobc check cured.frob

An early return:

  $ cat > early.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (watching look)
  > 
  > look :: (HasSonar i, DiffDrive o) => Task i o Bool
  > look = do
  >     d <- ask frontSonar
  >     if d < 0.3[m] then return False else return True
  >     forward 0.5[m]
  >     return True
  > FROB
  $ frobc check early.frob 2>&1 | grep hint
    = hint: move the remaining statements into the other branch: `if d < 0.3[m] then return False else do`
  $ sed 's/else return True/else do/;s/^    forward/        forward/;s/^    return/        return/' early.frob > cured.frob
  $ frobc check cured.frob

Different units in an array:

  $ cat > array.frob <<'FROB'
  > main :: SF (Distance, Velocity) (Array 2 Float)
  > main = proc (d, v) -> [d, v]
  > FROB
  $ frobc check array.frob 2>&1 | grep 'requires\|by the\|hint'
    |         --------------------------------------- by the signature of `main`, an element of the output is `Float`
    = hint: to get a plain number, divide by the unit: `d / 1[m]`
    = hint: if all elements of the array have this unit, write `Distance` in the signature; if they have different units, use a tuple here and in the signature
    |         --------------------------------------- by the signature of `main`, an element of the output is `Float`
    = hint: to get a plain number, divide by the unit: `v / 1[m/s]`
    = hint: if all elements of the array have this unit, write `Velocity` in the signature; if they have different units, use a tuple here and in the signature
  $ printf 'main :: SF (Distance, Velocity) (Distance, Velocity)\nmain = proc (d, v) -> (d, v)\n' > cured.frob
  $ frobc check cured.frob
