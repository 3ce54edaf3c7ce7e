A program requests controls from its operator: buttons, knobs and others. They are part of its
input, under their labels; both engines agree, whatever the operator does.

  $ cat > panel.frob <<'FROB'
  > import Geometry
  > import Robot
  > 
  > -- One function for several knobs: labels and numbers are handed on.
  > dial :: HasConsole i => String -> Velocity -> i -> Velocity
  > dial name top i = knob name 0 top (top / 2) i
  > 
  > main :: SF Console (Int, Velocity, Velocity, Bool, Bool, Point2)
  > main = proc c -> (presses, slow, fast, toggle "lights" True c, buttonHeld "drive" c, goal) where
  >     presses = hold 0 (accum 0 (mapE (\_ n -> n + 1) (buttonPressed "go" c)))
  >     slow = dial "slow" 0.1[m/s] c
  >     fast = dial "top speed" top c
  >     top = 0.4[m/s] + slowest
  >     goal = hold (Vec2 { x = 0, y = 0 }) (mapClicked c)
  > 
  > slowest :: Velocity
  > slowest = 0.1[m/s]
  > FROB
  $ frobc report panel.frob | sed -n '/console/,$p'
  the operator's console
    go              button                                panel.frob:10
    slow              knob  0 to 0.1 m/s, initially 0.05  panel.frob:6
    top speed         knob  0 to 0.5 m/s, initially 0.25  panel.frob:6
    map                map                                panel.frob:14
    lights          toggle  initially on                  panel.frob:9
    drive      button held                                panel.frob:9
  $ cat > in.csv <<'CSV'
  > time,in.go,in.slow,in.top speed,in.lights,in.drive,in.map
  > 0,,0.05,0.25,true,false,
  > 1,(),0.07,0.3,false,true,"(1, -2)"
  > 2,(),0.07,0.3,false,true,
  > CSV
  $ frobc trace panel.frob --lint --input in.csv | tee c.csv
  time,out.1,out.2,out.3,out.4,out.5,out.6.x,out.6.y
  0.000000000,0,0.050000000000000003,0.25,true,false,0,0
  1.000000000,1,0.070000000000000007,0.29999999999999999,false,true,1,-2
  2.000000000,2,0.070000000000000007,0.29999999999999999,false,true,1,-2
  $ frobc trace panel.frob --input in.csv --engine interp | cmp - c.csv

A knob is never outside its limits and never NaN, whatever the input contains.

  $ printf 'time,in.slow,in.top speed\n0,-1,9\n1,nan,inf\n2,-inf,nan\n' > odd.csv
  $ frobc trace panel.frob --input odd.csv | tee c.csv | cut -d, -f1,3,4
  time,out.2,out.3
  0.000000000,0,0.5
  1.000000000,0.050000000000000003,0.5
  2.000000000,0,0.25
  $ frobc trace panel.frob --input odd.csv --engine interp | cmp - c.csv

Omitted columns, of controls that are not operated.

  $ printf 'time\n0\n1\n' | frobc trace panel.frob --input - | tee c.csv
  time,out.1,out.2,out.3,out.4,out.5,out.6.x,out.6.y
  0.000000000,0,0.050000000000000003,0.25,true,false,0,0
  1.000000000,0,0.050000000000000003,0.25,true,false,0,0
  $ printf 'time\n0\n1\n' | frobc trace panel.frob --input - --engine interp | cmp - c.csv
  $ printf 'time,in.gone\n0,\n' | frobc trace panel.frob --input -
  error: standard input:1:6: the program's input has no `in.gone`
  [2]
  $ printf 'time,in.gone\n0,\n' | frobc trace panel.frob --input - --engine interp
  error: standard input:1:6: the program's input has no `in.gone`
  [2]

The same in single precision.

  $ frobc trace panel.frob --real float --input odd.csv > c.csv
  $ frobc trace panel.frob --real float --input odd.csv --engine interp | cmp - c.csv

The console in C: after the robot's struct.

  $ cat > drive.frob <<'FROB'
  > import Robot
  > 
  > main :: (HasConsole i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (if buttonHeld "drive" i then knob "speed" 0 0.4[m/s] 0.2[m/s] i else 0) 0))
  > FROB
  $ frobc compile drive.frob --robot scout
  $ sed -n '/^struct drive_console/,/^};/p;/^struct drive_input/,/^};/p' drive.h
  struct drive_console {
      bool drive;
      double speed;
  };
  struct drive_input {
      struct frob_scout_input robot;
      struct drive_console console;
  };
  $ frobc report drive.frob --robot scout --format json | sed 's/.*"console"/"console"/'
  "console":[{"label":"drive","kind":"hold","line":4},{"label":"speed","kind":"knob","least":0,"most":0.4,"first":0.2,"unit":"m/s","line":4}],"params":[],"params_bytes":0,"marks":0,"wire":{"robot":"scout","steps":[{"quantity":"each wheel","size":2.54,"unit":"mm/s"},{"quantity":"resulting turn rate","size":0.42158539966172975,"unit":"deg/s"}]},"assertions":0,"assertion_operations":0,"assertion_bytes":0}

`Console` is the console that is never operated; a robot without a console uses
it.

  $ cat > alone.frob <<'FROB'
  > import Robot
  > import Capability
  > 
  > data Tin = Tin { speed :: Velocity }
  > 
  > instance HasConsole Tin where
  >     keyPressed _ = NoEvent
  > 
  > main :: SF Tin (Bool, Velocity, Bool, Event ())
  > main = proc i -> (buttonHeld "a" i, knob "b" 0 1[m/s] 0.5[m/s] i, toggle "c" True Console, buttonPressed "d" i)
  > FROB
  $ printf 'time,in.speed\n0,3\n' | frobc trace alone.frob --input -
  time,out.1,out.2,out.3,out.4
  0.000000000,false,0.5,true,
  $ printf 'time,in.speed\n0,3\n' | frobc trace alone.frob --input - --engine interp
  time,out.1,out.2,out.3,out.4
  0.000000000,false,0.5,true,
