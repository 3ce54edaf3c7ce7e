A program that requires capabilities can be compiled for each robot that has
them.

  $ cat > follow.frob <<'FROB'
  > import Robot
  > 
  > approach :: (HasSonar i, DiffDrive o) => Distance -> SF i o
  > approach d = proc i -> roMake (setVelTR (0.5[1/s] * (frontSonar i - d)) 0)
  > 
  > main :: (HasSonar i, DiffDrive o) => Program i o
  > main = reactimateRobot (approach 0.3[m])
  > FROB
  $ for robot in pioneer scout create; do
  >   frobc compile --lint follow.frob --robot $robot -o $robot
  >   grep -o 'frob_[a-z]*_[a-z]*put \*' $robot/follow.h
  >   gcc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -fsyntax-only \
  >     -I "$(dirname "$(command -v frobc)")/../share/frobc/include" $robot/follow.c
  > done
  frob_pioneer_input *
  frob_pioneer_output *
  frob_pioneer_input *
  frob_pioneer_output *
  frob_scout_input *
  frob_scout_output *
  frob_scout_input *
  frob_scout_output *
  frob_create_input *
  frob_create_output *
  frob_create_input *
  frob_create_output *

`frobc check` accepts it without a robot; compiling, tracing and reporting
require one.

  $ frobc check --lint follow.frob
  $ frobc compile follow.frob
  error[E0502]: the type of `main` does not say which robot it runs on
   --> follow.frob:7:1
    |
  7 | main = reactimateRobot (approach 0.3[m])
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: `pioneer`, `scout`, `create` and `ros` have everything that the program needs: compile it with `--robot pioneer`, `--robot scout`, `--robot create` or `--robot ros`
  
  1 error
  [1]
  $ echo time | frobc trace follow.frob --input - 2>&1 | head -1
  error[E0502]: the type of `main` does not say which robot it runs on
  $ frobc report follow.frob 2>&1 | head -1
  error[E0502]: the type of `main` does not say which robot it runs on
  $ frobc report follow.frob --robot create | head -3
  state, in bytes
    approach                                       72                                follow.frob:4
      frontSonar@CreateInput.nearestAhead.lastHeard  48  2 times nearestAhead          Ranging.frob:86

Both engines run it for any of these robots. A Create's light bumpers detect a wall at half a metre
and nearer: the signal at one metre would be 2.5.

  $ {
  >   printf 'time,in.odometry.position.x,in.odometry.position.y,in.odometry.heading,in.leftWheel,in.rightWheel,in.bumpLeft,in.bumpRight,in.leftDrop,in.rightDrop,'
  >   printf 'in.cliffs[0],in.cliffs[1],in.cliffs[2],in.cliffs[3],in.light[0],in.light[1],in.light[2],in.light[3],in.light[4],in.light[5],'
  >   printf 'in.virtualWall,in.beacon,in.leftOvercurrent,in.rightOvercurrent,in.cleanButton,in.battery,in.charge,in.charging,in.obeying,in.key,in.cliffSignals[0],in.cliffSignals[1],in.cliffSignals[2],in.cliffSignals[3]\n'
  >   for light in 0 40 40; do
  >     printf '%d,0,0,0,0,0,false,false,false,false,' $((n = n + 1))
  >     printf 'false,false,false,false,0,0,%d,%d,0,0,' $light $light
  >     printf 'false,0,false,false,false,15,1,false,true,,0,0,0,0\n'
  >   done
  > } > wall.csv
  $ frobc trace follow.frob --robot create --input wall.csv | tee compiled.csv | cut -d, -f1-3
  time,out.forward,out.turn
  1.000000000,0.10000000000000001,0
  2.000000000,-0.021809807497359585,0
  3.000000000,-0.021809807497359585,0
  $ frobc trace --lint follow.frob --robot create --input wall.csv --engine interp | cmp - compiled.csv

If a robot lacks a capability, the message points to the line of the program that needs it, not to
the library.

  $ cat > careful.frob <<'FROB'
  > import Robot
  > 
  > speed i = if cliffAhead i then 0 else 0.2[m/s]
  > 
  > careful :: (HasCliffs i, DiffDrive o) => SF i o
  > careful = proc i -> roMake (setVelTR (speed i) 0)
  > 
  > main :: (HasCliffs i, DiffDrive o) => Program i o
  > main = reactimateRobot careful
  > FROB
  $ frobc check --lint careful.frob
  $ frobc check --lint careful.frob --robot create
  $ frobc check careful.frob --robot scout
  error[E0503]: `scout` has no `HasCliffs`
   --> careful.frob:3:14
    |
  3 | speed i = if cliffAhead i then 0 else 0.2[m/s]
    |              ^^^^^^^^^^ `cliffAhead` needs it
    |
    = note: only `create` has this capability
    = note: `main` is compiled for `scout`, but there is no instance `HasCliffs ScoutInput`
    = hint: compile it with `--robot create`
  
  1 error
  [1]
  $ frobc compile careful.frob
  error[E0502]: the type of `main` does not say which robot it runs on
   --> careful.frob:9:1
    |
  9 | main = reactimateRobot careful
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: `create` has everything that the program needs: compile it with `--robot create`
  
  1 error
  [1]

No robot has both a ring of sonars and light sensors:

  $ cat > shining.frob <<'FROB'
  > import Robot
  > main :: (HasSonarRing i, HasLight o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setLight (if near i then On else Off))) where
  >     near i = isEvent ((sonars i ! 0).echo)
  > FROB
  $ frobc compile shining.frob
  error[E0503]: no robot has everything that `main` needs
   --> shining.frob:3:1
    |
  3 | main = reactimateRobot (proc i -> roMake (setLight (if near i then On else Off))) where
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |                                           |
    |                                           `pioneer` has no `HasLight`, which `setLight` needs
    |                                           `scout` has no `HasLight`, which `setLight` needs
    |                                           `ros` has no `HasLight`, which `setLight` needs
  4 |     near i = isEvent ((sonars i ! 0).echo)
    |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |                        |
    |                        `create` has no `HasSonarRing`, which `sonars` needs
    |
    = note: for your own robot, give the file of its module: `--robot FILE.frob`
  
  1 error
  [1]

A capability in a signature is required even if nothing uses it:

  $ cat > promise.frob <<'FROB'
  > import Robot
  > main :: (HasBeacon i, DiffDrive o) => Program i o
  > main = reactimateRobot (constant (roMake (setVelTR 0.2[m/s] 0)))
  > FROB
  $ frobc compile promise.frob --robot pioneer
  error[E0503]: `pioneer` has no `HasBeacon`
   --> promise.frob:3:1
    |
  3 | main = reactimateRobot (constant (roMake (setVelTR 0.2[m/s] 0)))
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ `main` needs it
    |
    = note: only `create` has this capability
    = note: `main` is compiled for `pioneer`, but there is no instance `HasBeacon PioneerInput`
    = hint: compile it with `--robot create`
  
  1 error
  [1]

Without a signature, a program is for the robot of `RobotInput`, unless an option names another one.

  $ cat > unsigned.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR (velocity i + 0.1[m/s]) 0))
  > FROB
  $ frobc compile unsigned.frob && grep -o 'frob_[a-z]*_[a-z]*put \*' unsigned.h
  frob_pioneer_input *
  frob_pioneer_output *
  frob_pioneer_input *
  frob_pioneer_output *
  $ frobc compile unsigned.frob --robot scout && grep -o 'frob_[a-z]*_[a-z]*put \*' unsigned.h
  frob_scout_input *
  frob_scout_output *
  frob_scout_input *
  frob_scout_output *

A program for one robot does not fit another, and a program with the input of
one robot and the output of another fits none.

  $ cat > one.frob <<'FROB'
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (constant (roMake id))
  > FROB
  $ frobc check one.frob --robot pioneer
  $ frobc check one.frob --robot scout
  error[E0503]: `main` is a program for `pioneer`, not for `scout`
   --> one.frob:3:1
    |
  3 | main = reactimateRobot (constant (roMake id))
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: allow any robot, as in `main :: (HasSonar i, DiffDrive o) => Program i o`
  
  1 error
  [1]
  $ cat > half.frob <<'FROB'
  > import Robot
  > import Scout
  > main :: Program RobotInput ScoutOutput
  > main = reactimateRobot (constant (roMake id))
  > FROB
  $ frobc check half.frob
  error[E0503]: `main` has the input of `pioneer` but the output of `scout`
   --> half.frob:4:1
    |
  4 | main = reactimateRobot (constant (roMake id))
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  
  1 error
  [1]
  $ cat > other_half.frob <<'FROB'
  > import Robot
  > main :: HasOdometry i => Program i RobotOutput
  > main = reactimateRobot (proc i -> roMake (setVelTR (velocity i) 0))
  > FROB
  $ frobc compile other_half.frob && grep -o 'frob_[a-z]*_[a-z]*put \*' other_half.h
  frob_pioneer_input *
  frob_pioneer_output *
  frob_pioneer_input *
  frob_pioneer_output *

A missing or invalid world is reported before the robot that it would have named:

  $ cat > open.frob <<'FROB'
  > import Robot
  > main :: (HasOdometry i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> setVelTR (if position2X i > 1[m] then 0 else 0.1[m/s]) 0) where
  >     position2X i = (position i).x
  > FROB
  $ frobc run open.frob --world nowhere.toml
  error: there is no world `nowhere.toml` here or next to open.frob or among the worlds that come with frobc: room.toml
  [2]
  $ echo 'robot = "crate"' > wrong.toml
  $ frobc run open.frob --world wrong.toml
  error: wrong.toml:1:1: a world needs a table [start] with `x` and `y`, the position at which the robot starts
  error: wrong.toml:1:9: there is no robot `crate`; the robots are pioneer, scout, create, ros; remove `robot` if the world is for your own robot
  [2]
