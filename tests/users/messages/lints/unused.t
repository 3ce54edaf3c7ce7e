Unused definitions: a rule that was never connected is reported at its equation.

  $ cat > never_wired.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0[1/s]) where
  >     near = frontSonar i < 0.3[m]
  >     stop = near || bumped i
  >     v = 0.2[m/s])
  > FROB
  $ frobc check never_wired.frob
  warning[W0304]: `stop` is defined here, but nothing uses it
   --> never_wired.frob:5:5
    |
  5 |     stop = near || bumped i
    |     ^^^^
    |
    = hint: use it in an output, or remove it; if it is unused on purpose, rename it to `_stop`
  
  1 warning

Equations that only use each other, one that uses itself, a pattern that is unused or partially
used, the result of a task:

  $ cat > circles.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> x + low where
  >     a = delay 0 b
  >     b = a + 1
  >     n = delay 0 (n + 1)
  >     (p, q) = (x, delay 0 p)
  >     (low, high) = (min 0 x, max 0 x)
  > 
  > twice :: Task Float Float ()
  > twice = do
  >     let k = 2
  >     r <- sleepT 1[s] 0
  >     sleepT 1[s] 1
  > FROB
  $ frobc check circles.frob
  warning[W0304]: `a` is defined here, but nothing uses it
   --> circles.frob:3:5
    |
  3 |     a = delay 0 b
    |     ^
    |
    = note: `a` and `b` are used only by each other
    = hint: use it in an output, or remove it; if it is unused on purpose, rename it to `_a`
  
  warning[W0304]: `n` is defined here, but nothing uses it
   --> circles.frob:5:5
    |
  5 |     n = delay 0 (n + 1)
    |     ^
    |
    = note: only its own equation uses it
    = hint: use it in an output, or remove it; if it is unused on purpose, rename it to `_n`
  
  warning[W0304]: these are defined here, but nothing uses them
   --> circles.frob:6:5
    |
  6 |     (p, q) = (x, delay 0 p)
    |     ^^^^^^
    |
    = note: only its own equation uses it
    = hint: use one of them in an output, or remove the equation
  
  warning[W0305]: `high` is never used
   --> circles.frob:7:11
    |
  7 |     (low, high) = (min 0 x, max 0 x)
    |           ^^^^
    |
    = hint: replace it with `_` or `_high`
  
  warning[W0304]: `k` is defined here, but nothing uses it
    --> circles.frob:11:9
     |
  11 |     let k = 2
     |         ^
     |
     = hint: use it in an output, or remove it; if it is unused on purpose, rename it to `_k`
  
  warning[W0305]: `r` is never used
    --> circles.frob:12:5
     |
  12 |     r <- sleepT 1[s] 0
     |     ^
     |
     = hint: replace it with `_` or `_r`
  
  6 warnings

A name that starts with `_` has no warning, and neither have the names that it uses; in a program
with errors, the errors are reported first.

  $ cat > silent.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> x where
  >     a = 2 * x
  >     _later = a + 1
  >     (_b, _c) = (x, x)
  >     f _y = x
  >     _ = f 1
  > 
  > fourth :: Float -> Float
  > fourth _x = 4
  > FROB
  $ frobc check silent.frob
  $ sed 's/x where/z where/; s/_later/later/' silent.frob > faulty.frob
  $ frobc check faulty.frob
  error[E0205]: unknown name `z`
   --> faulty.frob:2:18
    |
  2 | main = proc x -> z where
    |                  ^
  
  1 error
  [1]

Unused imports, and unused names in import lists; a name that the header re-exports is used.

  $ cat > imports.frob <<'FROB'
  > import Control
  > import Geometry (norm, Pose, Vec2)
  > import qualified Ranging as R
  > 
  > main :: SF Float Float
  > main = proc x -> norm (Vec2 { x = x, y = 0 })
  > FROB
  $ frobc check imports.frob
  warning[W0306]: `Control` is imported, but nothing from it is used
   --> imports.frob:1:1
    |
  1 | import Control
    | ^^^^^^^^^^^^^^
    |
    = hint: remove it
  
  warning[W0306]: `Pose` is imported but not used
   --> imports.frob:2:24
    |
  2 | import Geometry (norm, Pose, Vec2)
    |                        ^^^^
    |
    = hint: remove it
  
  warning[W0306]: `Ranging` is imported, but nothing from it is used
   --> imports.frob:3:1
    |
  3 | import qualified Ranging as R
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: remove it
  
  3 warnings
  $ cat > gathered.frob <<'FROB'
  > module Gathered (lowPass, length2, heading) where
  > 
  > import Control
  > import Geometry
  > import Robot
  > 
  > length2 :: Float[m] -> Float[m^2]
  > length2 x = x * x
  > 
  > heading :: RobotInput -> Angle
  > heading i = i.odometry.heading
  > FROB
  $ frobc check gathered.frob

A module of the program may be imported only for its instances:

  $ cat > Boxes.frob <<'FROB'
  > class HasSize a where
  >     size :: a -> Float
  > FROB
  $ cat > Sizes.frob <<'FROB'
  > import Boxes
  > 
  > instance HasSize Bool where
  >     size b = if b then 1 else 0
  > FROB
  $ cat > sized.frob <<'FROB'
  > import Boxes
  > import Sizes
  > 
  > main :: SF Bool Float
  > main = proc b -> size b
  > FROB
  $ frobc check sized.frob

Many variables of one pattern have one warning.

  $ cat > many.frob <<'FROB'
  > main :: SF (Float, Float, Float, Float, Float, Float) Float
  > main = proc (a, b, c, d, e, f) -> c
  > FROB
  $ frobc check many.frob
  warning[W0305]: `a`, `b`, `d` and 2 more are never used
   --> many.frob:2:14
    |
  2 | main = proc (a, b, c, d, e, f) -> c
    |              ^
    |
    = hint: replace them with `_` or with names such as `_a`
  
  1 warning
