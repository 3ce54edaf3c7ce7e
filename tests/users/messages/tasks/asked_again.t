A task that checks a condition and continues: reported where the program checks
it.

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
  error[E0402]: `go → go` may repeat endlessly within one instant
   --> ask.frob:6:10
    |
  6 |     d <- ask frontSonar
    |          ^^^^^^^^^^^^^^ this may end as soon as it starts
  7 |     go
    |     -- `go` may start itself again at its own first instant
    |
    = note: no time passes between these steps when `go` ends as soon as it starts
    = hint: make the loop take time: add a task such as `sleepT 10[ms] restingOutput`, where `restingOutput` is the output of a robot at rest
  
  warning[W0306]: `Geometry` is imported, but nothing from it is used
   --> ask.frob:2:1
    |
  2 | import Geometry
    | ^^^^^^^^^^^^^^^
    |
    = hint: remove it
  
  warning[W0305]: `d` is never used
   --> ask.frob:6:5
    |
  6 |     d <- ask frontSonar
    |     ^
    |
    = hint: replace it with `_` or `_d`
  
  1 error, 2 warnings
  [1]
