Signatures with two types in the wrong order. Each program is one line under a signature; the test
shows the message without the source, and checks the signature with which the hint replaces it.

  $ try () { # SIGNATURE LINE CORRECTED-SIGNATURE
  >   printf 'import Control\nimport Robot\nf :: %s\n%b\n' "$1" "$2" > program.frob
  >   frobc check program.frob 2>&1 | grep '^error\|hint'
  >   printf 'import Control\nimport Robot\nf :: %s\n%b\n' "$3" "${4:-$2}" > corrected.frob
  >   frobc check corrected.frob 2>&1 | grep '^error'
  > }

  $ try 'SF AngularVelocity Distance' 'f = proc d -> limit 1[rad/s] (3[rad/(m s)] * (d - 0.4[m]))\nmain :: SF Distance AngularVelocity\nmain = proc d -> f d' 'SF Distance AngularVelocity'
  error[E0320]: the types in the signature of `f` are in the wrong order
    = hint: write the signature as `f :: SF Distance AngularVelocity`
  [1]
  $ try 'SF RobotOutput RobotInput' 'f = proc i -> roMake (setVelTR (0.5[1/s] * (frontSonar i - 0.4[m])) 0)' 'SF RobotInput RobotOutput'
  error[E0360]: the types in the signature of `f` are in the wrong order
    = hint: write the signature as `f :: SF RobotInput RobotOutput`
  [1]
  $ try '(HasSonar i, DiffDrive o) => SF o i' 'f = proc i -> roMake (setVelTR (0.5[1/s] * (frontSonar i - 0.4[m])) 0)\nmain :: Program RobotInput RobotOutput\nmain = reactimateRobot f' '(HasSonar i, DiffDrive o) => SF i o'
  error[E0309]: the types in the signature of `f` are in the wrong order
    = hint: write the signature as `f :: (HasSonar i, DiffDrive o) => SF i o`
  [1]
  $ try '(HasSonar i, DiffDrive o) => Task o i Bool' 'f = do\n    forward 1[m]\n    turnBy 90[deg]' '(HasSonar i, DiffDrive o) => Task i o Bool'
  error[E0309]: the types in the signature of `f` are in the wrong order
    = hint: write the signature as `f :: (HasSonar i, DiffDrive o) => Task i o Bool`
  [1]
  $ try 'SF (Event ()) Bool' 'f = proc b -> edge b' 'SF Bool (Event ())'
  error[E0301]: the types in the signature of `f` are in the wrong order
    = hint: write the signature as `f :: SF Bool (Event ())`
  [1]
  $ try 'SF (Velocity, Distance) Bool' 'f = proc (d, v) -> d < 0.4[m] && v > 0.1[m/s]' 'SF (Distance, Velocity) Bool'
  error[E0320]: the types in the signature of `f` are in the wrong order
    = hint: write the signature as `f :: SF (Distance, Velocity) Bool`
  [1]
  $ try 'Bool -> Distance' 'f d = d < 0.4[m]' 'Distance -> Bool'
  error[E0301]: the types in the signature of `f` are in the wrong order
    = hint: write the signature as `f :: Distance -> Bool`
  [1]

The parameters of a function may be in the wrong order as well:

  $ try 'Distance -> Velocity -> Velocity' 'f v d = if d < 1[m] then v / 2 else v' 'Velocity -> Distance -> Velocity'
  error[E0320]: the types in the signature of `f` are in the wrong order
    = hint: write the signature as `f :: Velocity -> Distance -> Velocity`, or begin the definition with `f d v =`
  [1]
  $ try 'Distance -> Velocity -> Velocity' 'f v d = if d < 1[m] then v / 2 else v' 'Distance -> Velocity -> Velocity' 'f d v = if d < 1[m] then v / 2 else v' | grep -v hint
  error[E0320]: the types in the signature of `f` are in the wrong order

A formula with the wrong operation can fit the other order by coincidence:

  $ try 'SF Velocity Distance' 'f = proc d -> derivative d' 'SF Distance Velocity'
  error[E0320]: expected the unit `m`, found `m/s^2`
    = hint: for the sum over time, write `integral d`
    = hint: if the types of the signature are in the wrong order, write it as `f :: SF Distance Velocity`
  [1]
