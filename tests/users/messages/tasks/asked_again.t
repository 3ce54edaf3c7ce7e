A task that asks, and goes on: shown where the program asks.

  $ cat > ask.frob <<'FROB'
  > import Robot
  > import Geometry
  > 
  > go :: Task RobotInput RobotOutput ()
  > go = do
  >     d <- ask frontSonar
  >     go
  > 
  > main = reactimateTask go
  > FROB
  $ frobc check ask.frob
  warning[W0306]: nothing of `Geometry` is used here
   --> ask.frob:2:1
    |
  2 | import Geometry
    | ^^^^^^^^^^^^^^^
    |
    = hint: take it out
  
  warning[W0305]: nothing reads `d`
   --> ask.frob:6:5
    |
  6 |     d <- ask frontSonar
    |     ^
    |
    = hint: write `_` in its place, or `_d`
  
  error[E0402]: `go → go` may go round for ever within one instant
   --> ask.frob:6:10
    |
  6 |     d <- ask frontSonar
    |          ^^^^^^^^^^^^^^ this may end as soon as it starts
  7 |     go
    |     -- `go` may go on to itself at its own first instant
    |
    = note: at an instant at which `go` is left as soon as it starts, nothing waits for the next one
    = hint: let time pass between: `sleepT 10[ms] …` after the task takes some, with the output meanwhile, such as the `restingOutput` of a robot
  
  1 error, 2 warnings
  [1]
