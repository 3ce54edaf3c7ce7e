Records instead of their components, components instead of records, and numbers instead of Bools.

  $ cat > heading.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR 0 w) where
  >     h = robotPose i.heading
  >     w = -0.5[1/s] * h)
  > FROB
  $ frobc check heading.frob
  error[E0301]: expected `Float[u]`, found `Pose`
   --> heading.frob:4:21
    |
  4 |     w = -0.5[1/s] * h)
    |          --------   ^
    |          |
    |          this is `Float[1/s]`
    |
    = hint: field access binds tighter than function application: write `(robotPose i).heading`
  
  1 error
  [1]

  $ cat > position.frob <<'FROB'
  > import Robot
  > import Geometry
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     p = robotPose i.heading
  >     v = if norm p.position > 1[m] then 0 else 0.2[m/s])
  > FROB
  $ frobc check position.frob
  error[E0310]: field access binds tighter than function application: this is a field of `i`
   --> position.frob:4:19
    |
  4 |     p = robotPose i.heading
    |                   ^^^^^^^^^
    |
    = hint: for a field of the result of `robotPose`, write `(robotPose i).heading`
  
  1 error
  [1]

  $ cat > nearest.frob <<'FROB'
  > import Robot
  > main :: (HasSonarRing i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     nearest = foldl min 5[m] (sonars i)
  >     v = if nearest < 0.4[m] then 0 else 0.3[m/s])
  > FROB
  $ frobc check nearest.frob
  error[E0301]: expected `Array 16 n[m]`, found `Array 16 Sonar`
   --> nearest.frob:4:31
    |
  4 |     nearest = foldl min 5[m] (sonars i)
    |               ----- ---       ^^^^^^^^
    |               |     |
    |               |     because this is `n[m] -> n[m] -> n[m]`
    |               argument 3 of `foldl` is `Array 16 n[m]`
    |
    = hint: its elements are records with the fields `seat`, `halfAngle` and `echo`: choose one, as in `map (\x -> x.echo)`
  
  1 error
  [1]

  $ cat > halve.frob <<'FROB'
  > data Cmd = Cmd { v :: Velocity, w :: AngularVelocity }
  > halve :: Cmd -> Cmd
  > halve c = c.v * 0.5
  > main :: SF Cmd Cmd
  > main = proc c -> halve c
  > FROB
  $ frobc check halve.frob
  error[E0301]: expected `Cmd`, found `Float[m/s]`
   --> halve.frob:3:11
    |
  2 | halve :: Cmd -> Cmd
    |          ---------- the signature of `halve` requires `Cmd`
  3 | halve c = c.v * 0.5
    |           ^^^^^^^^^
    |
    = hint: write the whole record, `Cmd { v = …, w = … }`, or a copy of a record `r` with a different `v`: `r { v = … }`
  
  1 error
  [1]

  $ cat > scale.frob <<'FROB'
  > scale :: (Float, Float) -> (Float, Float)
  > scale p = map (\x -> 2 * x) p
  > main :: SF (Float, Float) (Float, Float)
  > main = proc p -> scale p
  > FROB
  $ frobc check scale.frob
  error[E0301]: expected `Array m n[u]`, found a tuple with 2 elements
   --> scale.frob:2:29
    |
  2 | scale p = map (\x -> 2 * x) p
    |           ---               ^
    |           |
    |           argument 2 of `map` is `Array m n[u]`
    |
    = hint: take the tuple apart in an equation, `(a, b) = p`, and write an array in brackets, `[a, b]`
  
  1 error
  [1]

  $ cat > truth.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = if bumped i == 1 then 0 else 0.3[m/s])
  > FROB
  $ frobc check truth.frob
  error[E0301]: expected `Bool`, found a number
   --> truth.frob:3:24
    |
  3 |     v = if bumped i == 1 then 0 else 0.3[m/s])
    |            --------    ^
    |            |
    |            this is `Bool`
    |
    = hint: this is already a `Bool`: write `bumped i`
  
  1 error
  [1]

  $ cat > pixels.frob <<'FROB'
  > import Vision
  > seen :: Blob -> Bool
  > seen b = b.pixels > 50[px]
  > main :: SF Blob Bool
  > main = proc b -> seen b
  > FROB
  $ frobc check pixels.frob
  error[E0320]: the operands of `>` have different units: `1` and `px`
   --> pixels.frob:3:21
    |
  3 | seen b = b.pixels > 50[px]
    |          --------   ^^^^^^ this is `Int[px]`
    |          |
    |          this is `Int`
    |
    = hint: `b.pixels` is a plain number: write `50`
  
  1 error
  [1]
