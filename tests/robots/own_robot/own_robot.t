A user-defined robot: the file of its module takes the place of a robot's name. frobc generates a C
header from the module, next to the program.

  $ rover=../../../examples/own_robot
  $ follow=../../../examples/wall_follow/wall_follow.frob
  $ frobc check --lint $follow --robot $rover/Rover.frob
  $ frobc compile $follow --robot $rover/Rover.frob -o generated
  $ ls generated
  rover.h
  wall_follow.c
  wall_follow.h
  $ grep include generated/wall_follow.h | head -1
  #include "rover.h"
  $ frobc header $rover/Rover.frob | cmp - generated/rover.h

Its C is also valid C++; the body requires C++20, which has designated initializers. C compilers do
not warn about the omitted members, except clang 19 when it compiles C++.

  $ compiles () {
  >   for source in $2; do
  >     $1 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -ffp-contract=off -Igenerated -I../../../runtime -I../../../runtime/include -fsyntax-only $3 $source
  >   done
  > }
  $ others=$(ls generated/wall_follow.c $rover/*.c | grep -v body)
  $ compiles "gcc -std=c99" "$others $rover/rover_body.c"
  $ compiles "clang -std=c99" "$others $rover/rover_body.c"
  $ compiles "g++ -x c++ -std=c++17" "$others"
  $ compiles "clang++ -x c++ -std=c++20" $rover/rover_body.c -Wno-missing-field-initializers

The wall follower drives it once round its room, unchanged, with its simulated body; and the
recording replays on both engines.

  $ frobc run $follow --robot $rover/Rover.frob --with $rover/rover_body.c --for 60s --seed 1 --record run.csv | grep -E 'error:|collisions'
  mean wall distance error: 0.0150 m
  largest wall distance error: 0.1328 m
  collisions: 0
  $ frobc trace $follow --robot $rover/Rover.frob --input run.csv > replayed.csv
  $ frobc trace $follow --robot $rover/Rover.frob --input run.csv --engine interp | cmp - replayed.csv
  $ head -1 replayed.csv
  time,out.forward,out.turn

The same in single precision: the robot's structs have doubles, and the table for hosts converts.

  $ frobc run $follow --real float --robot $rover/Rover.frob --with $rover/rover_body.c --for 60s --seed 1 --record run.csv | grep -E 'error:|collisions'
  mean wall distance error: 0.0146 m
  largest wall distance error: 0.1335 m
  collisions: 0
  $ frobc trace $follow --real float --robot $rover/Rover.frob --input run.csv > replayed.csv
  $ frobc trace $follow --real float --robot $rover/Rover.frob --input run.csv --engine interp | cmp - replayed.csv
  $ frobc compile $follow --real float --robot $rover/Rover.frob -o single
  $ ls single
  rover.h
  wall_follow.c
  wall_follow.h
  $ frobc header $rover/Rover.frob | cmp - single/rover.h

All its C files may be given at once.

  $ all=$(printf -- '--with %s ' $rover/*.c)
  $ frobc run ../../../examples/patrol/patrol.frob --robot $rover/Rover.frob $all --for 60s --strict | grep collisions
  collisions: 0
  $ frobc build $follow --robot $rover/Rover.frob $all -o wall_follow
  $ ./wall_follow --help | sed -n '/^Settings/,$p'
  Settings:
    baud               rate of the serial line, bits per second, 9600 to 115200 (57600)
    watchdog           milliseconds without a speed command after which the robot stops, 100 to 2000 (500)
    counts             encoder counts per metre of travel, 100 to 1e+06 (8000)
    wheel-separation   distance between the wheels, m, 0.05 to 1 (0.19)
    patience           timeout for the answer to a command, s, 0.01 to 1 (0.06)
  $ frobc build $follow --robot $rover/Rover.frob $all --target linux -o wall_follow && ./wall_follow --help | grep watchdog
    watchdog           milliseconds without a speed command after which the robot stops, 100 to 2000 (500)

An exported library contains the headers that its C files include; each file compiles separately, in
both precisions.

  $ frobc export $follow --robot $rover/Rover.frob $all --platformio library
  $ ls library/examples
  wall_follow
  $ ls library/src | grep -i rover
  rover.h
  rover_board.c
  rover_body.c
  rover_driver.c
  rover_driver.h
  rover_odometry.c
  rover_odometry.h
  rover_wire.c
  rover_wire.h
  $ grep '= &' library/src/wall_follow_driver.c
  const struct frob_driver *const frob_own_driver = &frob_rover_driver;
  $ builds () { for source in library/src/*.c; do gcc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -ffp-contract=off -Ilibrary/src -c $source -o out.o || echo $source; done; }
  $ builds
  $ frobc export $follow --real float --robot $rover/Rover.frob $all --platformio library && builds

A program can import its module, like any other.

  $ cat > own.frob <<'FROB'
  > import Robot
  > import Rover
  > 
  > main :: Program RoverInput RoverOutput
  > main = reactimateRobot (proc i -> resting { forward = min 0.2[m/s] (0.5[1/s] * (frontSonar i - 0.3[m])) })
  > FROB
  $ frobc run own.frob --robot $rover/Rover.frob --with $rover/rover_body.c --for 5s | grep collisions
  collisions: 0
  $ frobc run own.frob --robot scout
  error[E0201]: there is no module `Rover`
   --> own.frob:2:8
    |
  2 | import Rover
    |        ^^^^^
    |
    = note: frobc looked for `Rover.frob` in the folder of this file and in the library
  
  1 error
  [1]

Missing definitions are reported.

  $ frobc run $follow --robot $rover/Rover.frob
  error: there is no simulated rover; for your own robot, define its body `frob_rover_body` in a C file, and add the file with `--with`
  [2]
  $ frobc build $follow --robot $rover/Rover.frob
  error: ../../../examples/own_robot/Rover.frob is your own robot: add the C files of its driver, which define `frob_rover_driver`, with `--with FILE.c`
  [2]
  $ frobc run $follow --robot Rover.frob
  error: there is no file Rover.frob
  [2]

The comment at the top of the C names the robot's file, whose name cannot end that comment.

  $ mkdir 'odd*' && cp $rover/Rover.frob 'odd*'
  $ frobc compile $follow --robot 'odd*/Rover.frob' -o odd && sed -n "3s/[0-9.]*,/VERSION,/p" odd/*.c
   * frobc VERSION, --robot odd* /Rover.frob
  $ cat > bumping.frob <<'FROB'
  > import Robot
  > main :: (HasBumpers i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (if bumped i then 0 else 0.2[m/s]) 0))
  > FROB
  $ frobc check bumping.frob --robot $rover/Rover.frob
  error[E0503]: `rover` has no `HasBumpers`
   --> bumping.frob:3:56
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR (if bumped i then 0 else 0.2[m/s]) 0))
    |                                                        ^^^^^^ `bumped` needs it
    |
    = note: `pioneer`, `scout`, `create` and `ros` have this capability
    = note: `main` is compiled for `rover`, but there is no instance `HasBumpers RoverInput`
    = hint: compile it with `--robot pioneer`, `--robot scout`, `--robot create` or `--robot ros`
  
  1 error
  [1]
  $ printf 'data RoverInput = RoverInput { x :: Float }\n' > Little.frob
  $ frobc check bumping.frob --robot Little.frob
  error[E0503]: the module `Little` does not describe a robot: there is no record `LittleInput`
   --> Little.frob:1:1
    |
  1 | data RoverInput = RoverInput { x :: Float }
    | ^
    |
    = hint: define records `LittleInput` and `LittleOutput`, and an instance for each capability of the robot
  
  1 error
  [1]
  $ cp $rover/Rover.frob Scout.frob
  $ frobc check bumping.frob --robot Scout.frob
  error: there is already a robot `scout`: rename Scout.frob
  [2]
