If an argument does not fit, the message shows the earlier argument that
determined the type.

  $ cat > sizes.frob <<'FROB'
  > import Robot
  > main :: (HasSonarRing i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     nearest = foldl min 5[m] (sonars i)
  >     v = if nearest < 0.4[m] then 0 else 0.3[m/s])
  > FROB
  $ frobc check sizes.frob
  error[E0301]: expected `Array 16 n[m]`, found `Array 16 Sonar`
   --> sizes.frob:4:31
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

  $ cat > function.frob <<'FROB'
  > import Control
  > f :: Float -> Bool
  > f x = x > 1
  > main :: SF (Array 3 Int) Bool
  > main = proc xs -> any f xs
  > FROB
  $ frobc check function.frob
  error[E0312]: expected `Array 3 Float`, found `Array 3 Int`
   --> function.frob:5:25
    |
  5 | main = proc xs -> any f xs
    |                   --- - ^^
    |                   |   |
    |                   |   because this is `Float -> Bool`
    |                   argument 2 of `any` is `Array 3 Float`
    |
    = hint: write `map toFloat xs`
  
  1 error
  [1]

  $ cat > units.frob <<'FROB'
  > import Control
  > main :: SF (Float[m], Float[m/s]) Float[m]
  > main = proc (a, b) -> limit a b
  > FROB
  $ frobc check units.frob
  error[E0320]: expected the unit `m`, found `m/s`
   --> units.frob:3:31
    |
  3 | main = proc (a, b) -> limit a b
    |                       ----- - ^ this is `Float[m/s]`
    |                       |     |
    |                       |     because this is `Float[m]`
    |                       argument 2 of `limit` is `Float[m]`
    |
    = hint: multiply by a time, as in `1[s] * b`, or, for the sum over time, write `integral b`
  
  1 error
  [1]

The first and the last argument exchanged:

  $ cat > label.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR (knob i "speed" 0 0.4[m/s] 0.2[m/s]) 0))
  > FROB
  $ frobc check label.frob
  error[E0301]: the arguments of `knob` are in the wrong order
   --> label.frob:2:53
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR (knob i "speed" 0 0.4[m/s] 0.2[m/s]) 0))
    |                                                     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: write `knob "speed" 0 0.4[m/s] 0.2[m/s] i`
  
  1 error
  [1]

Two mistakes of the same kind on a line are reported once:

  $ cat > image.frob <<'FROB'
  > import Robot
  > import Vision
  > red :: ColourRange
  > red = ColourRange { hueFrom = 340[deg], hueTo = 20[deg], saturationFrom = 0.5, saturationTo = 1, valueFrom = 0.2, valueTo = 1 }
  > main = reactimateRobot (proc i -> roMake (setVelTR 0 w) where
  >     blob = findBlob (camera i) (everywhere (camera i)) red
  >     w = if blob.cx > 160[px] then -0.3[rad/s] else 0.3[rad/s])
  > FROB
  $ frobc check image.frob
  error[E0301]: expected `Image`, found `Event Frame`
   --> image.frob:6:22
    |
  6 |     blob = findBlob (camera i) (everywhere (camera i)) red
    |            --------  ^^^^^^^^
    |            |
    |            argument 1 of `findBlob` is `Image`
    |
    = hint: an event has a value only when it occurs: write `mapE (\x -> findBlob x.image …) (camera i)` for an event with the result of `findBlob`
  
  1 error
  [1]

  $ cat > pair.frob <<'FROB'
  > main :: SF (Float, Float) Float
  > main = proc p -> p.0 + p.1
  > FROB
  $ frobc check pair.frob
  error[E0301]: expected `a -> b`, found `(Float, Float)`
   --> pair.frob:2:18
    |
  2 | main = proc p -> p.0 + p.1
    |                  ^- argument 1 of `.` is `b -> c`
    |
    = hint: to get the elements of a tuple, write an equation: `(a, b) = p`; for a pair, you can also write `fst p` and `snd p`
  
  1 error
  [1]
