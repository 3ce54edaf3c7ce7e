Outputs of robots where tasks are expected, and the other way round. Each program is given by its
lines; the test shows the hints, and checks the program with the lines that the hint suggests.

  $ try () { # PROGRAM CORRECTED-PROGRAM
  >   printf 'import Robot\n'"$1"'\n' > program.frob
  >   frobc check program.frob 2>&1 | grep '^error\|hint'
  >   printf 'import Robot\n'"$2"'\n' > corrected.frob; frobc check corrected.frob 2>&1 | grep '^error'
  > }
  $ M='go :: (HasSonar i, DiffDrive o) => Task i o Bool\ngo = do\n    forward 1[m]\n   '

Commands of the robot:

  $ try "$M roMake (setVelTR 0.3[m/s] 0)\n    forward 1[m]" "$M sleepT 1[s] (roMake (setVelTR 0.3[m/s] 0))\n    forward 1[m]"
  error[E0371]: `roMake` does not return a task, but `Task i o a` is needed here
    = hint: a robot command is not a task: to give it for a fixed time, write `sleepT 1[s] (roMake (setVelTR 0.3[m/s] 0))`; to give it until an event `e` occurs, write `mkTask (proc i -> (roMake (setVelTR 0.3[m/s] 0), e))`
  [1]
  $ try "$M sleepT 2[s] (setVelTR 0.3[m/s] 0)\n    forward 1[m]" "$M sleepT 2[s] (roMake (setVelTR 0.3[m/s] 0))\n    forward 1[m]"
  error[E0301]: expected the robot's output during that time, found `b -> b`
    = hint: write `roMake (setVelTR 0.3[m/s] 0)`
  [1]
  $ try "$M sleepT (roMake (setVelTR 0.3[m/s] 0)) 2[s]\n    forward 1[m]" "$M sleepT 2[s] (roMake (setVelTR 0.3[m/s] 0))\n    forward 1[m]"
  error[E0301]: the arguments of `sleepT` are in the wrong order
    = hint: write `sleepT 2[s] (roMake (setVelTR 0.3[m/s] 0))`
  [1]
  $ M='main :: Program RobotInput RobotOutput\nmain = reactimateRobot (proc _ ->'
  $ try "$M setVelTR 0.3[m/s] 0)" "$M roMake (setVelTR 0.3[m/s] 0))"
  error[E0301]: expected `Program RobotInput RobotOutput`, found `Program RobotInput (a -> a)`
    = hint: this only changes an output: for the robot's output itself, write `roMake (setVelTR 0.3[m/s] 0)`
  [1]
  $ try "$M (0.3[m/s], 0))" "$M roMake (setVelTR 0.3[m/s] 0))"
  error[E0301]: expected `Program RobotInput RobotOutput`, found `Program RobotInput (Float[m/s], n[u])`
    = hint: write `roMake (setVelTR 0.3[m/s] 0)` for a robot's output with this speed and turn rate
  [1]

Results and signal functions:

  $ M='go :: (HasSonar i, DiffDrive o) => Task i o Bool\ngo = do\n   '
  $ try "$M let d = ask frontSonar\n    forward (d - 0.5[m])" "$M d <- ask frontSonar\n    forward (d - 0.5[m])"
  error[E0301]: expected a number, found `Task a b Distance`
    = hint: run the task: write `d <- ask frontSonar` in place of `let d = ask frontSonar`
  [1]
  $ W='wander :: (HasSonar i, DiffDrive o) => SF i o\nwander = proc _ -> roMake (setVelTR 0.2[m/s] 0)'
  $ try "$M wander\n    forward 1[m]\n$W" "$M mkTask (wander &&& after 5[s])\n    forward 1[m]\n$W"
  error[E0371]: expected a task, found a signal function
    = hint: to run it for a fixed time, write `mkTask (wander &&& after 5[s])`; to run it forever, `mkTask (wander &&& never)`
  [1]
  $ try 'f :: Float -> Float\nf x = do\n    let y = x * 2\n    return y' 'f :: Float -> Float\nf x = y where\n    y = x * 2'
  error[E0301]: expected `Float`, found `Task a b c`
    = hint: `do` and `return` are only for tasks: end the line with `= y where`, and put `y = x * 2` below it
  [1]

An event as an output that must be a truth value:

  $ try 'f :: SF () Bool\nf = proc () -> after 5[s] ()' 'f :: SF () Bool\nf = proc () -> elapsed 5[s] ()'
  error[E0301]: expected `Bool`, found `Event ()`
    = hint: this occurs at only one instant: write `elapsed 5[s] ()`, which is True from then on
  [1]
  $ try 'f :: SF Bool Bool\nf = proc b -> falling b' 'f :: SF Bool Bool\nf = proc b -> isEvent (falling b)'
  error[E0301]: expected `Bool`, found `Event ()`
    = hint: use `isEvent (falling b)`, which is True when the event occurs
  [1]
