A loop of another language among the equations of a `proc`: the message says that equations are not
repeated.

  $ cat > loop.frob <<'FROB'
  > import Robot
  > 
  > drive = proc i -> do
  >     while frontSonar i > 0.5[m]
  >         setVelTR 0.3[m/s] 0
  > 
  > main = reactimateRobot drive
  > FROB
  $ frobc check loop.frob
  error[E0116]: a `proc` has no loops, so it cannot contain `while`
   --> loop.frob:4:5
    |
  4 |     while frontSonar i > 0.5[m]
    |     ^^^^^
    |
    = hint: all statements of a `proc` hold at every instant: choose a value with `if c then a else b`, or repeat a task with `whileT c t`
  
  1 error
  [1]

The same in the middle.

  $ cat > middle.frob <<'FROB'
  > import Robot
  > 
  > drive = proc i -> do
  >     repeat 10
  >     returnA -< roMake (setVelTR 0.3[m/s] 0)
  > 
  > main = reactimateRobot drive
  > FROB
  $ frobc check middle.frob
  error[E0116]: a `proc` has no loops, so it cannot contain `repeat`
   --> middle.frob:4:5
    |
  4 |     repeat 10
    |     ^^^^^^
    |
    = hint: all statements of a `proc` hold at every instant: choose a value with `if c then a else b`, or repeat a task with `whileT c t`
  
  1 error
  [1]

An Arduino's `delay`, and `sleep`.

  $ cat > wait.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (watching (do
  >     forward 1[m]
  >     delay(1000)
  >     forward 1[m]
  >     delay 2[s]))
  > FROB
  $ frobc check wait.frob
  error[E0371]: expected a task, found a signal function
   --> wait.frob:5:5
    |
  3 | main = reactimateTask (watching (do
    |                        -------- each task of this `do` must be `Task (Watched a) b c`
  4 |     forward 1[m]
  5 |     delay(1000)
    |     ^^^^^^^^^^^ this is `SF n[1] n[1]`
    |
    = hint: to wait with the robot at rest, write `sleepT 1[s] restingOutput`; `delay` returns the previous value of a signal
  
  error[E0371]: expected a task, found a signal function
   --> wait.frob:7:5
    |
  3 | main = reactimateTask (watching (do
    |                        -------- argument 1 of `watching` is `Task (Watched a) b c`
  ...
  7 |     delay 2[s]))
    |     ^^^^^^^^^^ this is `SF n[s] n[s]`
    |
    = hint: to wait with the robot at rest, write `sleepT 2[s] restingOutput`; `delay` returns the previous value of a signal
  
  2 errors
  [1]
  $ cat > sleep.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (watching (do
  >     forward 1[m]
  >     sleep 2[s]))
  > FROB
  $ frobc check sleep.frob
  error[E0205]: unknown name `sleep`
   --> sleep.frob:5:5
    |
  5 |     sleep 2[s]))
    |     ^^^^^
    |
    = hint: write `sleepT 2[s] restingOutput`, which keeps the robot at rest for that time
  
  1 error
  [1]

The fixes.

  $ cat > cured.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (watching (do
  >     whileT (proc i -> frontSonar i > 0.5[m]) (forward 0.1[m])
  >     sleepT 2[s] restingOutput
  >     forward 1[m]))
  > FROB
  $ frobc check cured.frob

A task whose signature names the robot's input, although `watching` requires any
input.

  $ cat > watched.frob <<'FROB'
  > import Robot
  > 
  > patrol :: Task RobotInput RobotOutput Bool
  > patrol = do
  >     forward 1[m]
  >     turnBy 90[deg]
  >     forward 1[m]
  > 
  > main = reactimateTask (watching patrol)
  > FROB
  $ frobc check watched.frob
  error[E0301]: expected a task with the input `Watched a`, but this one has the input `RobotInput`
   --> watched.frob:9:33
    |
  9 | main = reactimateTask (watching patrol)
    |                        -------- ^^^^^^
    |                        |
    |                        argument 1 of `watching` is `Task (Watched a) b c`
    |
    = hint: `watching` adds a value to the input, so the task must accept any input with the capabilities that it uses: `(HasSonar i, DiffDrive o) => Task i o Bool`
  
  1 error
  [1]
  $ sed 's/^patrol ::.*/patrol :: (HasSonar i, DiffDrive o) => Task i o Bool/' watched.frob > any.frob
  $ frobc check any.frob

Modules of other languages for functions that need no import.

  $ for m in Maths Time List Random; do
  >   printf 'import %s\n\nmain :: SF Float Float\nmain = proc x -> sqrt x\n' $m > m.frob
  >   frobc check m.frob 2>&1 | grep -e error -e hint
  > done
  error[E0201]: there is no module `Maths`
    = hint: remove this line: mathematical functions are built in, as in `sin x` and `sqrt x`
  1 error
  error[E0201]: there is no module `Time`
    = hint: remove this line: time is built in; write `time ()` for the time since the start of the program
  1 error
  error[E0201]: there is no module `List`
    = hint: remove this line: arrays are built in, as in `map f xs` and `foldl (+) 0 xs`
  1 error
  error[E0201]: there is no module `Random`
    = hint: write `import Sources` instead; `whiteNoise 1 ()` returns random numbers, with 1 as the seed
  1 error

An undefined colour.

  $ cat > colour.frob <<'FROB'
  > import Robot
  > import Vision
  > 
  > side :: Frame -> Angle
  > side f = bearing (lens f.image) (findBlob f.image (everywhere f.image) red).cx
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR 0 (1[1/s] * hold 0 (mapE side (camera i)))))
  > FROB
  $ frobc check colour.frob
  error[E0205]: unknown name `red`
   --> colour.frob:5:72
    |
  5 | side f = bearing (lens f.image) (findBlob f.image (everywhere f.image) red).cx
    |                                                                        ^^^
    |
    = hint: describe a colour for the camera as a range: `ColourRange { hueFrom = 340[deg], hueTo = 20[deg], … }`, with `import Vision`
  
  1 error
  [1]
