Two controls with the same label: both places are shown.

  $ cat > kinds.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (if buttonHeld "go" i then speed i else 0) (turn i)))
  > 
  > speed i = knob "go" 0 0.4[m/s] 0.2[m/s] i
  > turn i = knob "turn" 0 1[rad/s] 0 i + knob "turn" 0 2[rad/s] 0 i
  > FROB
  $ frobc check kinds.frob
  error[E0442]: the console already has another control with the label `go`
   --> kinds.frob:5:11
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR (if buttonHeld "go" i then speed i else 0) (turn i)))
    |                                                        ----------------- a button to hold down
  4 |
  5 | speed i = knob "go" 0 0.4[m/s] 0.2[m/s] i
    |           ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ a knob from 0 to 0.4, initially 0.2
    |
    = hint: rename one of them
  
  error[E0442]: the console already has another control with the label `turn`
   --> kinds.frob:6:39
    |
  6 | turn i = knob "turn" 0 1[rad/s] 0 i + knob "turn" 0 2[rad/s] 0 i
    |          --------------------------   ^^^^^^^^^^^^^^^^^^^^^^^^^^ a knob from 0 to 2, initially 0
    |          |
    |          a knob from 0 to 1, initially 0
    |
    = hint: rename one of them
  
  2 errors
  [1]

The same limits in other units are different; if everything is the same, it is
one knob.

  $ cat > units.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (speed i) (turn i)))
  > 
  > speed i = knob "gain" 0 1[m/s] 0 i
  > turn i = knob "gain" 0 1[rad/s] 0 i
  > FROB
  $ frobc check units.frob
  error[E0442]: the console already has another control with the label `gain`
   --> units.frob:6:10
    |
  5 | speed i = knob "gain" 0 1[m/s] 0 i
    |           ------------------------ a knob from 0 to 1, initially 0, in m/s
  6 | turn i = knob "gain" 0 1[rad/s] 0 i
    |          ^^^^^^^^^^^^^^^^^^^^^^^^^^ a knob from 0 to 1, initially 0, in 1/s
    |
    = hint: rename one of them
  
  1 error
  [1]
  $ sed -i 's/^turn i.*/turn i = knob "gain" 0 1[m\/s] 0 i \/ 1[m]/' units.frob
  $ frobc check units.frob

Labels are known at compile time, and are valid column names.

  $ cat > labels.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (a i) (b i)))
  > 
  > a i = if buttonHeld (if bumped i then "x" else "y") i || buttonHeld "" i then 1[m/s] else 0
  > b i = if buttonHeld "a, b" i || buttonHeld "it is \"so\"" i || buttonHeld " c" i || buttonHeld "a label that is longer than it is wise to be" i then 1[rad/s] else 0
  > FROB
  $ frobc check labels.frob
  error[E0440]: this label is not known at compile time
   --> labels.frob:5:10
    |
  5 | a i = if buttonHeld (if bumped i then "x" else "y") i || buttonHeld "" i then 1[m/s] else 0
    |          ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: give each button and knob a fixed label, and choose between their values
  
  error[E0440]: a label cannot be empty
   --> labels.frob:5:58
    |
  5 | a i = if buttonHeld (if bumped i then "x" else "y") i || buttonHeld "" i then 1[m/s] else 0
    |                                                          ^^^^^^^^^^^^^^^
  
  error[E0440]: a label cannot contain a comma, a quote, a backslash or a line break
   --> labels.frob:6:10
    |
  6 | b i = if buttonHeld "a, b" i || buttonHeld "it is \"so\"" i || buttonHeld " c" i || buttonHeld "a label that is longer t…
    |          ^^^^^^^^^^^^^^^^^^^
  
  error[E0440]: a label cannot contain a comma, a quote, a backslash or a line break
   --> labels.frob:6:33
    |
  6 | b i = if buttonHeld "a, b" i || buttonHeld "it is \"so\"" i || buttonHeld " c" i || buttonHeld "a label that is longer t…
    |                                 ^^^^^^^^^^^^^^^^^^^^^^^^^^^
  
  error[E0440]: a label cannot begin or end with a space
   --> labels.frob:6:64
    |
  6 | … b" i || buttonHeld "it is \"so\"" i || buttonHeld " c" i || buttonHeld "a label that is longer than it is wise to be" i…
    |                                          ^^^^^^^^^^^^^^^^^
  
  error[E0440]: a label can have at most 40 characters
   --> labels.frob:6:85
    |
  6 | …it is \"so\"" i || buttonHeld " c" i || buttonHeld "a label that is longer than it is wise to be" i then 1[rad/s] else 0
    |                                          ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  
  6 errors
  [1]

The numbers of a knob.

  $ cat > numbers.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (a i) (b i)))
  > 
  > a i = knob "a" 1[m/s] 0 0.5[m/s] i + knob "b" 0 1[m/s] 2[m/s] i + knob "c" 0 (1[m/s] / 0) 0 i
  > b i = knob "d" 0 (1[rad/s] * 0 / 0) 0 i + knob "e" 0 (turnRate i) 0 i + (if toggle "f" (bumped i) i then 1[rad/s] else 0)
  > FROB
  $ sed -i 's/ + knob "e" 0 (turnRate i) 0 i/ + knob "e" 0 (batteryVoltage i * 1[1\/(V s)]) 0 i/' numbers.frob
  $ frobc check numbers.frob
  error[E0441]: the lower limit of this knob, 1, must be less than its upper limit, 0
   --> numbers.frob:5:7
    |
  5 | a i = knob "a" 1[m/s] 0 0.5[m/s] i + knob "b" 0 1[m/s] 2[m/s] i + knob "c" 0 (1[m/s] / 0) 0 i
    |       ^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  
  error[E0441]: the initial value of this knob, 2, is outside its limits, 0 and 1
   --> numbers.frob:5:38
    |
  5 | a i = knob "a" 1[m/s] 0 0.5[m/s] i + knob "b" 0 1[m/s] 2[m/s] i + knob "c" 0 (1[m/s] / 0) 0 i
    |                                      ^^^^^^^^^^^^^^^^^^^^^^^^^^
  
  error[E0441]: the limits and the initial value of a knob must be finite numbers
   --> numbers.frob:5:67
    |
  5 | a i = knob "a" 1[m/s] 0 0.5[m/s] i + knob "b" 0 1[m/s] 2[m/s] i + knob "c" 0 (1[m/s] / 0) 0 i
    |                                                                   ^^^^^^^^^^^^^^^^^^^^^^^^^^^
  
  error[E0441]: the limits and the initial value of a knob must be finite numbers
   --> numbers.frob:6:7
    |
  6 | b i = knob "d" 0 (1[rad/s] * 0 / 0) 0 i + knob "e" 0 (batteryVoltage i * 1[1/(V s)]) 0 i + (if toggle "f" (bumped i) i t…
    |       ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  
  error[E0441]: the limits and the initial value of this knob must be known at compile time
   --> numbers.frob:6:43
    |
  6 | …i = knob "d" 0 (1[rad/s] * 0 / 0) 0 i + knob "e" 0 (batteryVoltage i * 1[1/(V s)]) 0 i + (if toggle "f" (bumped i) i the…
    |                                          ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: you can use literals, constants, parameters with a constant value, and operators applied to these
    = hint: give the knob a fixed range, and scale its value
  
  error[E0441]: the initial position of this toggle must be known at compile time
   --> numbers.frob:6:96
    |
  6 | …atteryVoltage i * 1[1/(V s)]) 0 i + (if toggle "f" (bumped i) i then 1[rad/s] else 0)
    |                                          ^^^^^^^^^^^^^^^^^^^^^^^
  
  6 errors
  [1]

Units that do not fit.

  $ cat > other.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (knob "a" 0 1[rad] 0 i) 0))
  > FROB
  $ frobc check other.frob
  error[E0320]: expected the unit `m/s`, found none
   --> other.frob:3:53
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR (knob "a" 0 1[rad] 0 i) 0))
    |                                           --------  ^^^^^^^^^^^^^^^^^^^^^ this is `Float`
    |                                           |
    |                                           argument 1 of `setVelTR` is `Velocity` (m/s)
    |
    = hint: if the number is in `m/s`, multiply by the unit: `(knob "a" 0 1[rad] 0 i) * 1[m/s]`
  
  1 error
  [1]

A parameter is known if its argument is, through any number of definitions; the state of a signal
function is not.

  $ cat > parameters.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (legs 0)
  > 
  > -- Numbers that only count are no limits: the task goes round for ever.
  > legs :: (HasConsole i, DiffDrive o) => Int -> Task i o ()
  > legs n = do
  >     leg 0.3[m/s]
  >     leg (0.1[m/s] * 2)
  >     legs (n + 1)
  > 
  > leg :: (HasConsole i, DiffDrive o) => Velocity -> Task i o ()
  > leg top = mkTask (proc i -> (roMake (setVelTR (v i) 0), notYet (buttonPressed "next" i))) where
  >     v i = knob (if top > 0.25[m/s] then "fast" else "slow") 0 top (top / 2) i
  > FROB
  $ frobc report parameters.frob --robot scout | sed -n '/console/,$p'
  the operator's console
    next  button                                parameters.frob:13
    fast    knob  0 to 0.3 m/s, initially 0.15  parameters.frob:14
    slow    knob  0 to 0.2 m/s, initially 0.1   parameters.frob:14
  
  resolution of speed on the wire of a scout, averaged over commands
    each wheel             2.54 mm/s
    resulting turn rate  0.422 deg/s
