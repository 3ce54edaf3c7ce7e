Records, blocks and modules as in other languages. Every replacement that a message offers compiles when
it is pasted.

A `struct` with types of Frob:

  $ cat > struct.frob <<'FROB'
  > struct Reading {
  >     Distance range;   // in front
  >     Angle angle, error;
  > };
  > FROB
  $ frobc check struct.frob
  error[E0110]: Frob has no `struct`
   --> struct.frob:1:1
    |
  1 | struct Reading {
    | ^^^^^^
    |
    = hint: declare a record with `data` and a constructor: `data Reading = Reading { range :: Distance, angle :: Angle, error :: Angle }`
  
  1 error
  [1]
  $ sed -n '1s:.*:data Reading = Reading { range \:\: Distance, angle \:\: Angle, error \:\: Angle }:p' struct.frob > pasted.frob && frobc check pasted.frob

  $ cat > typedef.frob <<'FROB'
  > typedef struct {
  >     float x, y;
  > } Point;
  > FROB
  $ frobc check typedef.frob
  error[E0110]: Frob has no `typedef`
   --> typedef.frob:1:1
    |
  1 | typedef struct {
    | ^^^^^^^
    |
    = hint: declare a record with `data` and a constructor: `data Point = Point { x :: Float, y :: Float }`
  
  1 error
  [1]
  $ sed -n '1s:.*:data Point = Point { x \:\: Float, y \:\: Float }:p' typedef.frob > pasted.frob && frobc check pasted.frob

A record of Elm:

  $ cat > alias.frob <<'FROB'
  > type alias Reading = { range : Float, angle : Float }
  > 
  > far :: Reading -> Bool
  > far r = r.range > 3
  > FROB
  $ frobc check alias.frob
  error[E0103]: unexpected character `:`
   --> alias.frob:1:30
    |
  1 | type alias Reading = { range : Float, angle : Float }
    |                              ^
    |
    = hint: declare a record with `data` and a constructor: `data Reading = Reading { range :: Float, angle :: Float }`
  
  1 error
  [1]
  $ sed '1s:.*:data Reading = Reading { range \:\: Float, angle \:\: Float }:' alias.frob > pasted.frob && frobc check pasted.frob

  $ cat > alias_of_lines.frob <<'FROB'
  > type alias Reading =
  >     { range : Float
  >     , angle : Float
  >     }
  > FROB
  $ frobc check alias_of_lines.frob
  error[E0103]: unexpected character `:`
   --> alias_of_lines.frob:2:13
    |
  2 |     { range : Float
    |             ^
    |
    = hint: declare a record with `data` and a constructor: `data Reading = Reading { range :: Float, angle :: Float }`
  
  1 error
  [1]

A body in braces:

  $ cat > braces.frob <<'FROB'
  > import Robot
  > drive = proc i -> {
  >     float v = min(0.3[m/s], 0.5[1/s] * frontSonar i);
  >     return roMake (setVelTR v 0);
  > }
  > main = reactimateRobot drive
  > FROB
  $ frobc check braces.frob
  error[E0110]: expected the output of this `proc`, or `do`, after `->`, found `{`
   --> braces.frob:2:19
    |
  2 | drive = proc i -> {
    |                   ^
    |
    = hint: write the output first, and the equations below it in a `where`: `drive = proc i -> roMake (setVelTR v 0) where`, and below it, indented, `v = min 0.3[m/s] (0.5[1/s] * frontSonar i)`
  
  1 error
  [1]
  $ sed -e '2s:{:roMake (setVelTR v 0) where:' -e '3s:.*:    v = min 0.3[m/s] (0.5[1/s] * frontSonar i):' -e 4,5d braces.frob > pasted.frob && frobc check pasted.frob

A module that the library has under another name:

  $ cat > no_sonar.frob <<'FROB'
  > import Robot
  > import Sonar
  > main = reactimateRobot (proc i -> roMake (setVelTR (0.5[1/s] * frontSonar i) 0))
  > FROB
  $ frobc check no_sonar.frob
  error[E0201]: there is no module `Sonar`
   --> no_sonar.frob:2:8
    |
  2 | import Sonar
    |        ^^^^^
    |
    = note: frobc looked for `Sonar.frob` in the folder of this file and in the library
    = hint: remove this line: the sonars are in `Robot`, which is already imported
  
  1 error
  [1]
  $ sed 2d no_sonar.frob > pasted.frob && frobc check pasted.frob

  $ cat > no_camera.frob <<'FROB'
  > import Camera
  > FROB
  $ frobc check no_camera.frob
  error[E0201]: there is no module `Camera`
   --> no_camera.frob:1:8
    |
  1 | import Camera
    |        ^^^^^^
    |
    = note: frobc looked for `Camera.frob` in the folder of this file and in the library
    = hint: cameras are in `Vision`: write `import Vision`
  
  1 error
  [1]
  $ sed 's:Camera:Vision:' no_camera.frob > pasted.frob && frobc check pasted.frob

An import that lists its names:

  $ cat > listed.frob <<'FROB'
  > import Robot (frontSonar, reactimateRobot)
  > main = reactimateRobot (proc i -> roMake (setVelTR (0.5[1/s] * frontSonar i) 0))
  > FROB
  $ frobc check listed.frob
  error[E0205]: unknown name `roMake`
   --> listed.frob:2:35
    |
  1 | import Robot (frontSonar, reactimateRobot)
    | ------------------------------------------ this list lacks `roMake` and `setVelTR`
  2 | main = reactimateRobot (proc i -> roMake (setVelTR (0.5[1/s] * frontSonar i) 0))
    |                                   ^^^^^^
    |
    = hint: write `import Robot (frontSonar, reactimateRobot, roMake, setVelTR)`
  
  1 error
  [1]
  $ sed '1s:.*:import Robot (frontSonar, reactimateRobot, roMake, setVelTR):' listed.frob > pasted.frob && frobc check pasted.frob

The command of another robot, inside `roMake`:

  $ cat > speed.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc _ -> roMake (setSpeed 0.3[m/s] 0))
  > FROB
  $ frobc check speed.frob
  error[E0205]: unknown name `setSpeed`
   --> speed.frob:2:43
    |
  2 | main = reactimateRobot (proc _ -> roMake (setSpeed 0.3[m/s] 0))
    |                                           ^^^^^^^^
    |
    = hint: write `setVelTR 0.3[m/s] 0`, which sets the speed and the turn rate
  
  1 error
  [1]
  $ sed 's:setSpeed:setVelTR:' speed.frob > pasted.frob && frobc check pasted.frob

The size of an array as a divisor:

  $ cat > size.frob <<'FROB'
  > mean2 :: Array n Distance -> Distance
  > mean2 a = sum a / len a
  > FROB
  $ frobc check size.frob
  error[E0205]: unknown name `len`
   --> size.frob:2:19
    |
  2 | mean2 a = sum a / len a
    |                   ^^^
    |
    = hint: write `toFloat (length a)`
  
  1 error
  [1]
  $ sed 's:len a:toFloat (length a):' size.frob > pasted.frob && frobc check pasted.frob

Two equations for one name:

  $ cat > twice.frob <<'FROB'
  > f :: SF Float Float
  > f = proc x -> v where
  >     v = 0.5 * x
  >     v = min 3 v
  > FROB
  $ frobc check twice.frob
  error[E0212]: `v` is defined twice here
   --> twice.frob:4:5
    |
  3 |     v = 0.5 * x
    |     - first defined here
  4 |     v = min 3 v
    |     ^
    |
    = hint: write one equation, `v = min 3 (0.5 * x)`, because an equation holds at every instant, unlike an assignment
  
  1 error
  [1]
  $ sed -e '/v = 0.5/d' -e 's:min 3 v:min 3 (0.5 * x):' twice.frob > pasted.frob && frobc check pasted.frob

  $ cat > counter.frob <<'FROB'
  > f :: SF Float Int
  > f = proc x -> n where
  >     n = 0
  >     n = n + 1
  > FROB
  $ frobc check counter.frob
  error[E0212]: `n` is defined twice here
   --> counter.frob:4:5
    |
  3 |     n = 0
    |     - first defined here
  4 |     n = n + 1
    |     ^
    |
    = hint: write one equation, in which `delay` returns the previous value: `n = delay 0 n + 1`
  
  1 error
  [1]
  $ sed -e '/n = 0/d' -e 's:n = n + 1:n = delay 0 n + 1:' counter.frob > pasted.frob && frobc check pasted.frob
  warning[W0305]: `x` is never used
   --> pasted.frob:2:10
    |
  2 | f = proc x -> n where
    |          ^
    |
    = hint: replace it with `_` or `_x`
  
  1 warning

  $ cat > two_values.frob <<'FROB'
  > f :: SF Bool Float
  > f = proc fast -> v where
  >     v = 0.2
  >     v = 0.4
  > FROB
  $ frobc check two_values.frob
  error[E0212]: `v` is defined twice here
   --> two_values.frob:4:5
    |
  3 |     v = 0.2
    |     - first defined here
  4 |     v = 0.4
    |     ^
    |
    = hint: write one equation, because an equation holds at every instant, unlike an assignment; to choose between the two values, write `v = if c then 0.4 else 0.2`, with your condition in place of `c`
  
  1 error
  [1]
  $ sed -e '/v = 0.2/d' -e 's:v = 0.4:v = if fast then 0.4 else 0.2:' two_values.frob > pasted.frob && frobc check pasted.frob
