Numbers far from the place where their unit does not fit: the message labels the number that lacks
the unit or has the wrong one. Each program is given by its lines; the test shows the message
without the source, and checks the program with the lines that the hint suggests.

  $ try () { # PROGRAM CORRECTED-PROGRAM
  >   printf 'import Control\nimport Robot\n'"$1"'\n' > program.frob
  >   frobc check program.frob 2>&1 | grep '^error\|this number\|is this\|hint'
  >   printf 'import Control\nimport Robot\n'"$2"'\n' > corrected.frob; frobc check corrected.frob 2>&1 | grep '^error'
  > }

A function without a signature compares its parameter with a number:

  $ M='main :: SF RobotInput Bool\nmain = proc i -> near (frontSonar i)'
  $ try "near d = d < 0.4\n$M" "near d = d < 0.4[m]\n$M"
  error[E0320]: expected no unit, found `m`
    |              --- this number lacks the unit
    = hint: write `0.4[m]` in the definition of `near` if that is the right unit
  [1]
  $ try "near d = d < 0.4[s]\n$M" "near d = d < 0.4[m]\n$M"
  error[E0320]: expected the unit `s`, found `m`
    |              ------ this number is in `s`
    = hint: write `0.4[m]` in the definition of `near` if you meant that unit
  [1]
  $ try "$M where\n    near = proc d -> d - 0.4 < 0" "$M where\n    near = proc d -> d - 0.4[m] < 0"
  error[E0320]: expected no unit, found `m`
    |                          --- this number lacks the unit
    = hint: write `0.4[m]` in the definition of `near` if that is the right unit
  [1]

Each use of a local function has this hint:

  $ try 'main :: SF Distance Distance\nmain = proc x -> near x + near (2 * x) where\n    near d = d - 0.4' 'main :: SF Distance Distance\nmain = proc x -> near x + near (2 * x) where\n    near d = d - 0.4[m]'
  error[E0320]: expected no unit, found `m`
    |                  --- this number lacks the unit
    = hint: write `0.4[m]` in the definition of `near` if that is the right unit
  error[E0320]: expected no unit, found `m`
    |                  --- this number lacks the unit
    = hint: write `0.4[m]` in the definition of `near` if that is the right unit
  [1]

The result is one of several numbers:

  $ M='main :: Program RobotInput RobotOutput\nmain = reactimateRobot (proc i -> roMake (setVelTR (speed (frontSonar i)) 0))'
  $ try "speed d = if d > 1[m] then 0.3 else 0.1\n$M" "speed d = if d > 1[m] then 0.3[m/s] else 0.1[m/s]\n$M"
  error[E0320]: expected the unit `m/s`, found none
    |                            ---      --- this number lacks the unit
    |                            this number lacks the unit
    = hint: write `0.3[m/s]` and `0.1[m/s]` if that is the right unit
  [1]
  $ M='main :: Program RobotInput RobotOutput\nmain = reactimateRobot (proc i -> roMake (setVelTR 0 w) where\n    w = if frontSonar i > 1[m] then 0 else'
  $ try "$M 0.5[m/s])" "$M 0.5[rad/s])"
  error[E0320]: expected the unit `1/s`, found `m/s`
    |                                            -------- this number is in `m/s`
    = hint: write `0.5[rad/s]` if you meant that unit
  [1]
  $ try "turn = 0.5[m/s]\n$M turn)" "turn = 0.5[rad/s]\n$M turn)"
  error[E0320]: expected the unit `1/s`, found `m/s`
    |        -------- `turn` is defined as this number, which is in `m/s`
    = hint: write `0.5[rad/s]` if you meant that unit
  [1]

The only number with a decimal point in a formula, and a number for a parameter without a unit:

  $ M='main :: SF Float Distance\nmain = travelled'
  $ try 'travelled :: Float -> Distance\ntravelled n = n / 512 * 2 * pi * 0.04' 'travelled :: Float -> Distance\ntravelled n = n / 512 * 2 * pi * 0.04[m]'
  error[E0320]: expected the unit `m`, found none
    |               ^^^^^^^^^^^^^^^^^^^^^^^ this number has no unit
    = hint: if `0.04` is in `m`, write `0.04[m]`
  [1]
  $ try 'twice :: Float -> Float\ntwice x = 2 * x\nf :: Float\nf = twice 3[m]' 'twice :: Float -> Float\ntwice x = 2 * x\nf :: Float\nf = twice 3'
  error[E0320]: expected no unit, found `m`
    = hint: write `3`, without a unit, if it is a plain number
  [1]

A gain of a rate that needs no unit, although the other one has the same unit:

  $ M='u :: SF Distance Velocity\nu = proc d -> kp * (d - 0.5[m]) + kd * derivative d'
  $ try "kp = 0.5[1/s]\nkd = 0.2[1/s]\n$M" "kp = 0.5[1/s]\nkd = 0.2\n$M"
  error[E0320]: the operands of `+` have different units: `m/s` and `m/s^2`
    |      -------- `kd` is defined as this number
    = hint: if the gain `kd` should have no unit, write `kd = 0.2`
  [1]

A whole number where a quantity is expected:

  $ M='main :: Program RobotInput RobotOutput\nmain = reactimateRobot (proc i -> roMake (setVelTR speed 0))'
  $ try "speed :: Int\nspeed = 200\n$M" "speed :: Float[m/s]\nspeed = 200[mm/s]\n$M"
  error[E0312]: expected `Velocity` (m/s), found `Int`
    |         --- `speed` is defined as this number, which has no unit
    = hint: give `speed` its unit: `speed :: Float[m/s]` and `speed = 200[mm/s]`
  [1]
  $ try 'main :: SF Int Bool\nmain = proc n -> near n\nnear :: Distance -> Bool\nnear d = d < 1[m]' 'main :: SF Int Bool\nmain = proc n -> near (toFloat n * 1[m])\nnear :: Distance -> Bool\nnear d = d < 1[m]'
  error[E0312]: expected `Distance` (m), found `Int`
    = hint: if the number is in `m`, write `toFloat n * 1[m]`
  [1]

Two quantities that cannot be added:

  $ try 'f :: AngularVelocity -> Distance -> Velocity\nf w r = w + r' 'f :: AngularVelocity -> Distance -> Velocity\nf w r = w * r'
  error[E0320]: the operands of `+` have different units: `1/s` and `m`
    = hint: the operands of `+` must have the same unit: for a rate in `m/s`, write `w * r`
  [1]
  $ try 'f :: Velocity -> AngularVelocity -> Velocity\nf v w = v + w / 2' 'f :: Velocity -> AngularVelocity -> Velocity\nf v w = v + w / 2 * 1[m]'
  error[E0320]: the operands of `+` have different units: `m/s` and `1/s`
    = hint: the operands of `+` must have the same unit: multiply `w / 2` by a quantity in `m`, as in `v + w / 2 * 1[m]`
  [1]
