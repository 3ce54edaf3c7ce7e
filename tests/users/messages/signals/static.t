A signal where a static value is required: the message covers the two usual
intentions.

  $ cat > initial.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> delay x x
  > FROB
  $ frobc check initial.frob
  error[E0340]: the initial value of `delay` must be static, but `x` is a signal
   --> initial.frob:2:24
    |
  2 | main = proc x -> delay x x
    |             -          ^
    |             |
    |             `x` is a signal: it comes from the `proc`'s input here
    |
    = hint: write a constant, as in `delay 0 x`; to start with the first value of `x` instead, write `previous x`, with `import Control`
  
  1 error
  [1]

  $ cat > choice.frob <<'FROB'
  > import Control
  > main :: SF Float Float
  > main = proc x -> (if x > 0 then lowPass 1[s] else identity) x
  > FROB
  $ frobc check choice.frob
  error[E0340]: the signal function that runs here must be static, but `x` is a signal
   --> choice.frob:3:22
    |
  3 | main = proc x -> (if x > 0 then lowPass 1[s] else identity) x
    |             -        ^
    |             |
    |             `x` is a signal: it comes from the `proc`'s input here
    |
    = hint: run each signal function in a separate equation, and choose between their outputs
  
  1 error
  [1]

A task that continues as itself must take time.

  $ cat > local_task.frob <<'FROB'
  > import Geometry
  > import Robot
  > main = reactimateTask go where
  >     go = do
  >         driveTo (Vec2 { x = 1[m], y = 0 })
  >         go
  > FROB
  $ frobc check local_task.frob
  error[E0402]: `driveTo → go → driveTo` may repeat endlessly within one instant
    --> local_task.frob:6:9
     |
   6 |         go
     |         ^^ `driveTo` may start itself again at its own first instant
     |
    ::: stdlib/Driving.frob:89:5
     |
  89 |     arrived = atPlace goal i
     |     ------------------------ `atPlace` may occur at the first instant of `driveTo`
     |
     = note: no time passes between these steps when `atPlace` occurs as soon as `driveTo` starts
     = hint: make the loop take time: add a task such as `sleepT 10[ms] restingOutput`, where `restingOutput` is the output of a robot at rest
  
  1 error
  [1]
