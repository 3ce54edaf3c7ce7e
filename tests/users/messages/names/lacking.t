Declarations and equations that lack a part, or have one too many: the message is about the whole
construct.

Assertions and trials:

  $ cat > label_last.frob <<'FROB'
  > main :: SF Velocity Velocity
  > main = proc v -> w where
  >     w = min v 0.3[m/s]
  >     assert (w <= 0.3[m/s]) "slow enough"
  > FROB
  $ frobc check label_last.frob
  error[E0110]: the label of an `assert` must come first
   --> label_last.frob:4:5
    |
  4 |     assert (w <= 0.3[m/s]) "slow enough"
    |     ^^^^^^
    |
    = hint: write `assert "slow enough" (w <= 0.3[m/s])`
  
  1 error
  [1]

  $ cat > label_equals.frob <<'FROB'
  > main :: SF Velocity Velocity
  > main = proc v -> w where
  >     w = min v 0.3[m/s]
  >     assert "slow enough" = w <= 0.3[m/s]
  > FROB
  $ frobc check label_equals.frob
  error[E0110]: the condition must directly follow the label
   --> label_equals.frob:4:26
    |
  4 |     assert "slow enough" = w <= 0.3[m/s]
    |                          ^
    |
    = hint: write `assert "slow enough" (w <= 0.3[m/s])`
  
  1 error
  [1]

  $ cat > label_none.frob <<'FROB'
  > main :: SF Velocity Velocity
  > main = proc v -> w where
  >     w = min v 0.3[m/s]
  >     assert w <= 0.3[m/s]
  > FROB
  $ frobc check label_none.frob
  error[E0110]: an `assert` needs a label that describes its condition
   --> label_none.frob:4:5
    |
  4 |     assert w <= 0.3[m/s]
    |     ^^^^^^
    |
    = hint: write `assert "keeps off the wall" (w <= 0.3[m/s])`
  
  1 error
  [1]

  $ cat > trial_name.frob <<'FROB'
  > import Robot
  > import Trial
  > import WallFollow
  > main = reactimateRobot (wallFollow1 0.3[m])
  > trial touchesNothing = Trial { world = "room.toml", lasts = 60[s], seeds = 1 `to` 20, judge = neverTouches }
  > FROB
  $ frobc check trial_name.frob
  error[E0235]: the label of a `trial` must be in quotes
   --> trial_name.frob:5:7
    |
  5 | trial touchesNothing = Trial { world = "room.toml", lasts = 60[s], seeds = 1 `to` 20, judge = neverTouches }
    |       ^^^^^^^^^^^^^^
    |
    = hint: write `trial "touchesNothing" = …`
  
  1 error
  [1]

  $ cat > assert_in_task.frob <<'FROB'
  > import Robot
  > import Driving
  > main = reactimateTask (do
  >     forward 1[m]
  >     assert "moved" True
  >     turnBy 90[deg])
  > FROB
  $ frobc check assert_in_task.frob
  error[E0205]: unknown name `assert`
   --> assert_in_task.frob:5:5
    |
  5 |     assert "moved" True
    |     ^^^^^^
    |
    = hint: an assertion belongs among the equations of a `proc`: write `proc i -> y where`, with `assert "label" (y > 0)` on a line below
  
  1 error
  [1]

Parameters, modules and foreign declarations:

  $ cat > param_type.frob <<'FROB'
  > import Control
  > param gain = 0.5
  > main :: SF Float Float
  > main = proc x -> gain * x
  > FROB
  $ frobc check param_type.frob
  error[E0110]: a parameter needs a type before its value
   --> param_type.frob:2:12
    |
  2 | param gain = 0.5
    |            ^
    |
    = hint: write `param gain :: Float = 0.5`
  
  1 error
  [1]

  $ cat > param_choice.frob <<'FROB'
  > data Side = L | R
  > param side :: Side = L
  > main :: SF Float Float
  > main = proc x -> if side == L then x else -x
  > FROB
  $ frobc check param_choice.frob
  error[E0390]: the parameter `side` cannot have the type `Side`
   --> param_choice.frob:2:1
    |
  2 | param side :: Side = L
    | ^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: a parameter must be a number or a `Bool`, so that the command line can set it
    = hint: declare a separate parameter for each number in this value; for a choice, use a `Bool` or an `Int`
  
  1 error
  [1]

  $ cat > param_size.frob <<'FROB'
  > param n :: Int = 4
  > main :: SF (Array n Float) Float
  > main = proc xs -> sum xs
  > FROB
  $ frobc check param_size.frob
  error[E0411]: `main` cannot run: its type `SF (Array n Float) Float` has variables, so the input or the output is not determined
   --> param_size.frob:3:1
    |
  3 | main = proc xs -> sum xs
    | ^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: here `n` is a variable for any array size, not the value with that name: write a number, or name the size, as in `type N = 4`
  
  1 error
  [1]

  $ cat > folder.frob <<'FROB'
  > import lib/Geometry
  > main :: SF Float Float
  > main = proc x -> x
  > FROB
  $ frobc check folder.frob
  error[E0110]: expected the name of a module, starting with a capital letter, found `lib`
   --> folder.frob:1:8
    |
  1 | import lib/Geometry
    |        ^^^
    |
    = hint: name the module without its folder: `import Geometry`; its file must be in the same folder as this one, or in the library
  
  1 error
  [1]

  $ cat > head.frob <<'FROB'
  > module Pilot
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.1[m/s] 0))
  > FROB
  $ frobc check head.frob
  error[E0110]: a module header must end with `where`
   --> head.frob:1:13
    |
  1 | module Pilot
    |             ^
    |
    = hint: write `module Pilot where`; a module that exports everything needs no header
  
  1 error
  [1]

  $ cat > ccall.frob <<'FROB'
  > foreign import ccall "math.h sin" c_sin :: Float -> Float
  > main :: SF Float Float
  > main = proc x -> c_sin x
  > FROB
  $ frobc check ccall.frob
  error[E0110]: `foreign` must not be followed by `import`, and the C name must come last
   --> ccall.frob:1:9
    |
  1 | foreign import ccall "math.h sin" c_sin :: Float -> Float
    |         ^^^^^^
    |
    = hint: write `foreign c_sin :: Float -> Float = "sin"`
  
  1 error
  [1]

  $ cat > qualified.frob <<'FROB'
  > import qualified Geometry
  > main :: SF (Geometry.Vec2[m]) Distance
  > main = proc p -> norm p
  > FROB
  $ frobc check qualified.frob
  error[E0205]: unknown name `norm`
   --> qualified.frob:3:18
    |
  3 | main = proc p -> norm p
    |                  ^^^^
    |
    = hint: its module is imported with `qualified`: write `Geometry.norm`
  
  1 error
  [1]

  $ cat > text.frob <<'FROB'
  > foreign logc :: String -> Float -> Float = "log_it"
  > main :: SF Float Float
  > main = proc x -> logc "x" x
  > FROB
  $ frobc check text.frob
  error[E0380]: `logc` cannot give C a value of type `String`
   --> text.frob:1:17
    |
  1 | foreign logc :: String -> Float -> Float = "log_it"
    |                 ^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: functions, signal functions and labels exist only at compile time
    = hint: pass an `Int` that tells C which string you mean
  
  1 error
  [1]

Equations:

  $ cat > let.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     let d = frontSonar i
  >     v = 0.5[1/s] * (d - 0.3[m]))
  > FROB
  $ frobc check let.frob
  error[E0110]: the equations of a `where` cannot start with `let`
   --> let.frob:3:5
    |
  3 |     let d = frontSonar i
    |     ^^^
    |
    = hint: write `d = frontSonar i`
  
  1 error
  [1]

  $ cat > when.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = 0.3[m/s]
  >     when (frontSonar i < 0.5[m]) (v = 0))
  > FROB
  $ frobc check when.frob
  error[E0110]: an equation cannot be conditional: it holds at every instant
   --> when.frob:4:34
    |
  4 |     when (frontSonar i < 0.5[m]) (v = 0))
    |                                  ^^^^^^^^
    |
    = hint: choose the value in one equation: `v = if frontSonar i < 0.5[m] then 0 else …`
  
  1 error
  [1]

  $ cat > proc_equals.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i = roMake (setVelTR 0.2[m/s] 0))
  > FROB
  $ frobc check proc_equals.frob
  error[E0110]: expected `->` after the input of this `proc`, found `=`
   --> proc_equals.frob:2:32
    |
  2 | main = reactimateRobot (proc i = roMake (setVelTR 0.2[m/s] 0))
    |                                ^
    |
    = hint: write `->` between the input and the output; `=` is for equations
  
  1 error
  [1]

  $ cat > twice.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.1[m/s] 0))
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 0))
  > FROB
  $ frobc check twice.frob
  error[E0211]: the name `main` is defined twice
   --> twice.frob:3:1
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR 0.1[m/s] 0))
    | ---- first defined here
  3 | main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 0))
    | ^^^^
    |
    = hint: remove one of them, or rename it
  
  1 error
  [1]

  $ cat > constructors.frob <<'FROB'
  > data Mode = go | stop
  > main :: SF Bool Float
  > main = proc b -> if b then 1 else 0
  > FROB
  $ frobc check constructors.frob
  error[E0110]: expected the name of a constructor, starting with a capital letter, found `go`
   --> constructors.frob:1:13
    |
  1 | data Mode = go | stop
    |             ^^
    |
    = hint: start a constructor with a capital letter: `data Mode = Go | Stop`
  
  1 error
  [1]
