Classes used as types in signatures: before `=>`, in parentheses, and as a variable's type.

  $ cat > parentheses.frob <<'FROB'
  > import Robot
  > go :: HasSonar i, DiffDrive o => SF i o
  > go = proc i -> roMake (setVelTR (0.5[1/s] * (frontSonar i - 0.3[m])) 0)
  > main = reactimateRobot go
  > FROB
  $ frobc check parentheses.frob
  error[E0110]: several constraints need parentheses
   --> parentheses.frob:2:7
    |
  2 | go :: HasSonar i, DiffDrive o => SF i o
    |       ^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: write `(HasSonar i, DiffDrive o)`
  
  1 error
  [1]

  $ cat > arrow.frob <<'FROB'
  > import Robot
  > go :: (HasSonar i, DiffDrive o) -> SF i o
  > go = proc i -> roMake (setVelTR (0.5[1/s] * (frontSonar i - 0.3[m])) 0)
  > main = reactimateRobot go
  > FROB
  $ frobc check arrow.frob
  error[E0207]: `HasSonar` is a class, not a type
   --> arrow.frob:2:8
    |
  2 | go :: (HasSonar i, DiffDrive o) -> SF i o
    |        ^^^^^^^^
    |
    = hint: write the class before `=>` and use a type variable, as in `(HasSonar i, DiffDrive o) => SF i o`
  
  1 error
  [1]

  $ cat > types.frob <<'FROB'
  > import Robot
  > go :: SF HasSonar DiffDrive
  > go = proc i -> roMake (setVelTR (0.5[1/s] * (frontSonar i - 0.3[m])) 0)
  > main = reactimateRobot go
  > FROB
  $ frobc check types.frob
  error[E0207]: `HasSonar` is a class, not a type
   --> types.frob:2:10
    |
  2 | go :: SF HasSonar DiffDrive
    |          ^^^^^^^^
    |
    = hint: write the class before `=>` and use a type variable, as in `(HasSonar i, DiffDrive o) => SF i o`
  
  1 error
  [1]

  $ cat > exchanged.frob <<'FROB'
  > import Robot
  > go :: (HasSonar o, DiffDrive i) => SF i o
  > go = proc i -> roMake (setVelTR (0.5[1/s] * (frontSonar i - 0.3[m])) 0)
  > main = reactimateRobot go
  > FROB
  $ frobc check exchanged.frob
  error[E0309]: the signature of `go` does not declare `DiffDrive o` and `HasSonar i`
   --> exchanged.frob:2:8
    |
  2 | go :: (HasSonar o, DiffDrive i) => SF i o
    |        ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  3 | go = proc i -> roMake (setVelTR (0.5[1/s] * (frontSonar i - 0.3[m])) 0)
    |                        --------              ---------- `frontSonar` needs `HasSonar i`
    |                        |
    |                        `setVelTR` needs `DiffDrive o`
    |
    = hint: write `(HasSonar i, DiffDrive o) => SF i o`
  
  1 error
  [1]

  $ cat > added.frob <<'FROB'
  > import Robot
  > go :: (HasConsole i, DiffDrive o) => SF i o
  > go = proc i -> roMake (setVelTR (0.5[1/s] * (frontSonar i - 0.3[m])) 0)
  > main = reactimateRobot go
  > FROB
  $ frobc check added.frob
  error[E0309]: `frontSonar` needs `HasSonar i`, which the signature of `go` does not declare
    --> added.frob:3:46
     |
   2 | go :: (HasConsole i, DiffDrive o) => SF i o
     |        ------------------------------------ the signature of `go`
   3 | go = proc i -> roMake (setVelTR (0.5[1/s] * (frontSonar i - 0.3[m])) 0)
     |                                              ^^^^^^^^^^
     |
    ::: stdlib/Capability.frob:48:19
     |
  48 |     frontSonar :: SF i Distance
     |                   ------------- `frontSonar` requires `HasSonar i` here
     |
     = hint: write `(HasSonar i, HasConsole i, DiffDrive o) => SF i o`
  
  1 error
  [1]

A type that lacks an argument:

  $ cat > task.frob <<'FROB'
  > import Robot
  > import Driving
  > square :: (HasSonar i, DiffDrive o) => Task i o
  > square = do
  >     forward 1[m]
  >     turnBy 90[deg]
  > main = reactimateTask square
  > FROB
  $ frobc check task.frob
  error[E0216]: type `Task` takes 3 type arguments, not 2
   --> task.frob:3:40
    |
  3 | square :: (HasSonar i, DiffDrive o) => Task i o
    |                                        ^^^^^^^^
    |
    = hint: write the types of the input, the output and the result, as in `Task i o ()`; use `()` for no result
  
  1 error
  [1]
