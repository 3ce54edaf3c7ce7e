Records, operators and loops in the notation of other languages. The test pastes each fix.

A copy of a record with other fields, as in Elm, OCaml, JavaScript, Python and Rust:

  $ for e in '{ p | heading = 0 }' '{ p with heading = 0 }' '{ ...p, heading: 0 }' '{ **p, "heading": 0 }' 'Pose { ..p, heading = 0 }' '{ p with heading = 0; position = p.position }' 'id { p | heading = 0 }' 'p with { heading = 0 }' 'Pose { heading: 0, position: p.position }' 'p { heading: 0 }'; do
  >   printf 'import Geometry\nmain :: SF Pose Pose\nmain = proc p -> %s\n' "$e" > copy.frob
  >   frobc check copy.frob 2>&1 | grep -e ^error -e hint
  > done
  error[E0110]: expected the output of this `proc`, or `do`, after `->`, found `{`
    = hint: for a copy of the record with changed fields, write `p { heading = 0 }`
  error[E0110]: expected the output of this `proc`, or `do`, after `->`, found `{`
    = hint: for a copy of the record with changed fields, write `p { heading = 0 }`
  error[E0103]: unexpected character `:`
    = hint: for a copy of the record with changed fields, write `p { heading = 0 }`
  error[E0103]: unexpected character `:`
    = hint: for a copy of the record with changed fields, write `p { heading = 0 }`
  error[E0110]: expected the name of a field, found `.`
    = hint: for a copy of the record with changed fields, write `p { heading = 0 }`
  error[E0110]: expected the output of this `proc`, or `do`, after `->`, found `{`
    = hint: for a copy of the record with changed fields, write `p { heading = 0, position = p.position }`
  error[E0110]: expected `=`, `,` or `}` after the name of a field, found `|`
    = hint: for a copy of the record with changed fields, write `(p { heading = 0 })`
  error[E0205]: unknown name `with`
    = hint: remove `with`: `p { x = 1 }` is a copy of the record `p` in which the field `x` is 1
  error[E0103]: unexpected character `:`
    = hint: set a field with `=`: `Pose { heading = 0, position = p.position }`
  error[E0103]: unexpected character `:`
    = hint: set a field with `=`: `p { heading = 0 }`
  $ for e in 'p { heading = 0 }' 'p { heading = 0, position = p.position }' 'id (p { heading = 0 })' 'Pose { heading = 0, position = p.position }'; do
  >   printf 'import Geometry\nmain :: SF Pose Pose\nmain = proc p -> %s\n' "$e" > pasted.frob && frobc check pasted.frob
  > done
  $ printf 'import Geometry\nmain :: SF Pose Pose\nmain = proc p -> p where\n    p.heading = 0\n' > field.frob
  $ frobc check field.frob 2>&1 | grep hint
    = hint: Frob has no assignments: make a changed copy with a new name, as in `changed = p { heading = … }`

The opposite of a condition:

  $ cat > frame.frob <<'FROB'
  > import Robot
  > near :: Float -> Float -> Float -> Bool
  > near x y most = abs (x - y) < most
  > main :: SF RobotInput Bool
  > main = proc i -> y && bumped i where
  >     x = time () / 1[s]
  > FROB
  $ for e in '!near x 1 0.5 && x > 0' '!bumped i' '! bumped i' '~bumped i' '¬bumped i' 'not bumped i' '!(bumped i)' 'x > 0 && !bumped i'; do
  >   (cat frame.frob; echo "    y = $e") > negation.frob
  >   frobc check negation.frob 2>&1 | grep hint
  > done
    = hint: write `not (near x 1 0.5)`
    = hint: write `not (bumped i)`
    = hint: write `not (bumped i)`
    = hint: write `not (bumped i)`
    = hint: write `not (bumped i)`
    = hint: put parentheses around the argument: `not (bumped i)`
    = hint: write `not (bumped i)`
    = hint: write `not (bumped i)`
  $ for e in 'not (near x 1 0.5) && x > 0' 'near x 1 0.5 && not (bumped i)'; do
  >   (cat frame.frob; echo "    y = $e") > pasted.frob
  >   frobc check pasted.frob
  > done
  $ printf 'import Robot\nmain :: SF RobotInput Bool\nmain = proc i -> !bumped i\n' > fixed.frob
  $ frobc fix --all fixed.frob > /dev/null 2>&1; frobc check fixed.frob; tail -n 1 fixed.frob
  main = proc i -> not (bumped i)

A pipeline:

  $ cat > pipeline.frob <<'FROB'
  > import Control
  > main :: SF Velocity Velocity
  > main = proc v -> v |> deadband 0.05[m/s] |> limit 0.4[m/s]
  > FROB
  $ frobc check pipeline.frob 2>&1 | grep hint
    = hint: write each function before its argument: `limit 0.4[m/s] (deadband 0.05[m/s] v)`
  $ sed 's/v |>.*/limit 0.4[m\/s] (deadband 0.05[m\/s] v)/' pipeline.frob > pasted.frob && frobc check pasted.frob
  $ printf 'import Control\nmain :: SF Float Float\nmain = proc v -> v\n    |> deadband 0.05\n    |> limit 0.4\n' > lines.frob
  $ frobc check lines.frob 2>&1 | grep hint
    = hint: write each function before its argument: `limit 0.4 (deadband 0.05 v)`

An initial value and an assignment that changes it:

  $ cat > assignment.frob <<'FROB'
  > main :: SF Float AngularVelocity
  > main = proc _ -> omega where
  >     omega = 0.1[rad/s]
  >     omega += 0.01[rad/s]
  > FROB
  $ frobc check assignment.frob 2>&1 | grep hint
    = hint: Frob has no assignments: write an equation that holds at every instant: instead of both lines, write `omega = delay 0.1[rad/s] omega + 0.01[rad/s]`
  $ sed '3d; s/omega += .*/omega = delay 0.1[rad\/s] omega + 0.01[rad\/s]/' assignment.frob > pasted.frob && frobc check pasted.frob

The seeds of a trial:

  $ cat > seeds.frob <<'FROB'
  > import Robot
  > import Trial
  > main :: SF RobotInput RobotOutput
  > main = proc _ -> restingOutput
  > trial "ok" = Trial { world = "room.toml", lasts = 30[s], seeds = [1..10], judge = neverTouches }
  > FROB
  $ frobc check seeds.frob 2>&1 | grep hint
    = hint: use ``1 `to` 10`` without brackets; it includes both numbers
  $ sed 's/\[1\.\.10\]/1 `to` 10/' seeds.frob > pasted.frob && frobc check pasted.frob

Functions of Arduino, and a comment of MATLAB:

  $ for e in 'map(x, 0, 1023, 0, 5)' 'map(x, 10, 20, 1, 5)' 'constrain(x, -1, 5)' 'millis()' 'analogRead(3)' 'digitalWrite(13, x)' 'x    % slow'; do
  >   printf 'main :: SF Float Float\nmain = proc x -> y where\n    y = %s\n' "$e" > arduino.frob
  >   frobc check arduino.frob 2>&1 | grep -e ^error -e hint
  > done
  error[E0301]: `map` applies a function to each element of an array
    = hint: to convert a number from one range to another, write `x * 5 / 1023`
  error[E0301]: `map` applies a function to each element of an array
    = hint: to convert a number from one range to another, write `1 + (x - 10) * 4 / 10`
  error[E0205]: unknown name `constrain`
    = hint: write `clamp (-1) 5 x`, with `import Control`
  error[E0205]: unknown name `millis`
    = hint: use `time ()` for the time since the start, which has a unit, as in `1[s]`; the event `after 1[s] ()` occurs once, 1 s after the start, and `every 1[s] ()` occurs every second
  error[E0205]: unknown name `analogRead`
    = hint: a program reads pins through its input: add a field for the value to the input's type, and read the field, as in `proc i -> i.light > 0.5`; a robot's sensors are signal functions, such as `frontSonar i`
  error[E0205]: unknown name `digitalWrite`
    = hint: a program writes pins through its output: add a field for the value to the output's type, or combine robot commands, as in `roMake (setVelTR v omega . setLight On)`
  error[E0103]: unexpected character `%`
    = hint: write `--` to start a comment
  $ for e in 'x * 5 / 1023' '1 + (x - 10) * 4 / 10' 'x    -- slow'; do
  >   printf 'main :: SF Float Float\nmain = proc x -> y where\n    y = %s\n' "$e" > pasted.frob && frobc check pasted.frob
  > done
  $ printf 'import Control\nmain :: SF Float Float\nmain = proc x -> clamp (-1) 5 x\n' > pasted.frob && frobc check pasted.frob
  $ printf 'import Control\nmain :: SF Float Float\nmain = proc x -> constrain x 0 1\n' > imported.frob
  $ frobc check imported.frob 2>&1 | grep hint
    = hint: write `clamp 0 1 x`

A loop without an end, and the result of a task:

  $ cat > loop.frob <<'FROB'
  > import Robot
  > main = reactimateTask (watching (do
  >     while True do
  >         forward 1[m]
  >         turnBy 90[deg]))
  > FROB
  $ frobc check loop.frob 2>&1 | grep hint
    = hint: to repeat the tasks of this block, write `forever $ do` in place of this line
  $ sed 's/while True do/forever $ do/' loop.frob > pasted.frob && frobc check pasted.frob
  $ cat > result.frob <<'FROB'
  > import Robot
  > step :: (HasSonar i, DiffDrive o) => Task i o Bool
  > step = do
  >     ok = forward 1[m]
  >     if ok then turnBy 90[deg] else turnBy 180[deg]
  > main = reactimateTask (watching step)
  > FROB
  $ frobc check result.frob 2>&1 | grep hint
    = hint: for the result of a task, write `ok <- forward 1[m]`; for a value, write `let ok = forward 1[m]`
  $ sed 's/ok = /ok <- /' result.frob > pasted.frob && frobc check pasted.frob
  $ cat > dropped.frob <<'FROB'
  > import Robot
  > step :: (HasSonar i, DiffDrive o) => Task i o ()
  > step = do
  >     ok <- forward 1[m]
  >     if ok then return () else turnBy 180[deg]
  > main = reactimateTask (watching step)
  > FROB
  $ frobc check dropped.frob 2>&1 | grep hint
    = hint: to drop the result of this task, write `mapT (const ()) (turnBy 180[deg])`; in a `do`, you can also write `return ()` below it
  $ sed 's/else .*/else mapT (const ()) (turnBy 180[deg])/' dropped.frob > pasted.frob && frobc check pasted.frob
