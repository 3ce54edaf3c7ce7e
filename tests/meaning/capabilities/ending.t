A task that ends: from then on the robot stands still, and the output contains
the task's result. Both engines agree.

  $ cat > there_and_back.frob <<'FROB'
  > import Robot
  > 
  > driving :: DiffDrive o => Velocity -> o
  > driving v = roMake (setVelTR v 0)
  > 
  > main = reactimateTask (do
  >     sleepT 1[s] (driving 0.2[m/s])
  >     sleepT 1[s] (driving (-0.1[m/s]))
  >     p <- mapT place snapT
  >     return (p.x > 0))
  > FROB
  $ frobc run there_and_back.frob --for 3s --rate 2 --record run.csv | grep -v "per second\|log"
  time simulated: 3.000 s
  distance driven: 0.225 m
  odometry error at the end: 0.000 m
  collisions: 0
  finished after: 2.000 s
  result: true
  $ frobc trace --lint there_and_back.frob --input run.csv | tee compiled.csv
  time,out.forward,out.turn,out.result
  0.000000000,0.20000000000000001,0,
  0.500000000,0.20000000000000001,0,
  1.000000000,-0.10000000000000001,0,
  1.500000000,-0.10000000000000001,0,
  2.000000000,0,0,true
  2.500000000,0,0,true
  3.000000000,0,0,true
  $ frobc trace there_and_back.frob --input run.csv --engine interp | cmp - compiled.csv

In C, the robot's struct is the first member of the output.

  $ frobc compile there_and_back.frob
  $ sed -n '/^struct there_and_back_output/,/^}/p' there_and_back.h
  struct there_and_back_output {
      struct frob_pioneer_output command;
      struct there_and_back_event_bool result;
  };
  $ gcc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -fsyntax-only \
  >   -I "$(dirname "$(command -v frobc)")/../share/frobc/include" there_and_back.c

A run can end when its program ends. A result may have any type that can be
shown.

  $ cat > results.frob <<'FROB'
  > import Robot
  > type PioneerTask c = Task RobotInput RobotOutput c
  > data End = Stopped { after :: Distance, left :: Bool } | Lost
  > 
  > nothing = reactimateTask (return () :: PioneerTask ())
  > pair = reactimateTask (return (1, Just 2.5) :: PioneerTask (Int, Maybe Float))
  > end = reactimateTask (return (Stopped { after = 2[m], left = True }) :: PioneerTask End)
  > endless = reactimateTask (constT (roMake id) :: PioneerTask ())
  > several = reactimateTask (return [1.5, 2] :: PioneerTask (Array 2 Float))
  > FROB
  $ for entry in nothing pair end endless several; do
  >   frobc run results.frob --entry $entry --for 2s --exit-when-done | grep "simulated:\|finished\|result"
  > done
  time simulated: 0.000 s
  finished after: 0.000 s
  result: ()
  time simulated: 0.000 s
  finished after: 0.000 s
  result: (1, Just 2.5)
  time simulated: 0.000 s
  finished after: 0.000 s
  result: Stopped {after = 2, left = true}
  time simulated: 2.000 s
  time simulated: 0.000 s
  finished after: 0.000 s
  result: [1.5, 2]
  $ echo 'main = reactimateTask (return id :: Task RobotInput RobotOutput (Float -> Float))' | cat results.frob - > function.frob
  $ frobc compile function.frob
  error[E0412]: the result of `main` cannot be of type `Float -> Float`
    --> function.frob:10:1
     |
  10 | main = reactimateTask (return id :: Task RobotInput RobotOutput (Float -> Float))
     | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
     |
     = note: functions, signal functions and labels only exist at compile time
  
  1 error
  [1]

If the output is not a record, the result is stored next to it.

  $ cat > lamp.frob <<'FROB'
  > import Capability
  > import Robot
  > data Lamp = Dark | Bright
  > instance RobotOutput Lamp where
  >     restingOutput = Dark
  > 
  > main :: Program Float Lamp
  > main = reactimateTask (mkTask (proc x -> (Bright, edgeTag 7 (x > 1))))
  > FROB
  $ printf 'time,in\n0,0\n1,2\n2,0\n' > in.csv
  $ frobc trace --lint lamp.frob --input in.csv | tee compiled.csv
  time,out.1,out.2
  0.000000000,Bright,
  1.000000000,Dark,7
  2.000000000,Dark,7
  $ frobc trace lamp.frob --input in.csv --engine interp | cmp - compiled.csv

A program may choose between tasks when it starts, even between tasks that contain programs, if they
have results of the same type; otherwise only if the compiler can determine the choice.

  $ cat > choice.frob <<'FROB'
  > import Robot
  > type PioneerTask c = Task RobotInput RobotOutput c
  > short, long :: PioneerTask Int
  > short = mapT (const 1) (sleepT 1[s] (roMake id))
  > long = mapT (const 2) (sleepT 2[s] (roMake id))
  > isLong = sin 1 > 0
  > 
  > foreign isWindy :: Bool -> Bool = "is_windy"
  > 
  > task = reactimateTask (if isLong then long else short)
  > program = if isLong then reactimateTask long else reactimateTask short
  > unlike = if isWindy True then reactimateTask long else reactimateRobot (constant (roMake id))
  > FROB
  $ for entry in task program; do
  >   frobc run choice.frob --entry $entry --for 3s --rate 1 --record run.csv | grep "finished\|result"
  >   frobc trace --lint choice.frob --entry $entry --input run.csv > compiled.csv
  >   frobc trace choice.frob --entry $entry --input run.csv --engine interp | cmp - compiled.csv
  > done
  finished after: 2.000 s
  result: 2
  finished after: 2.000 s
  result: 2
  $ frobc compile choice.frob --entry unlike
  error[E0411]: `unlike` cannot run: it chooses between programs whose results have different types
    --> choice.frob:12:1
     |
  12 | unlike = if isWindy True then reactimateTask long else reactimateRobot (constant (roMake id))
     | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
     |
     = hint: choose between tasks inside one `reactimateTask`
  
  1 error
  [1]
