Keywords and blocks of other languages.

A block in braces has one message, whatever it contains:

  $ cat > braces.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> {
  >     v = 0.2[m/s];
  >     return roMake (setVelTR v 0);
  > })
  > FROB
  $ frobc check braces.frob
  error[E0110]: expected the output of this `proc`, or `do`, after `->`, found `{`
   --> braces.frob:2:35
    |
  2 | main = reactimateRobot (proc i -> {
    |                                   ^
    |
    = hint: write the output first, and the equations below it in a `where`: `main = reactimateRobot (proc i -> roMake (setVelTR v 0) where`, and below it, indented, `v = 0.2[m/s])`
  
  1 error
  [1]

  $ cat > end_word.frob <<'FROB'
  > clamp' x = if x > 1 then 1 else x end
  > main :: SF Float Float
  > main = proc x -> clamp' x
  > FROB
  $ frobc check end_word.frob
  error[E0205]: unknown name `end`
   --> end_word.frob:1:35
    |
  1 | clamp' x = if x > 1 then 1 else x end
    |                                   ^^^
    |
    = hint: remove it: a block ends where its indentation ends
  
  1 error
  [1]

  $ cat > from.frob <<'FROB'
  > from Robot import setVelTR
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.1[m/s] 0))
  > FROB
  $ frobc check from.frob
  error[E0110]: Frob has no `from`
   --> from.frob:1:1
    |
  1 | from Robot import setVelTR
    | ^^^^
    |
    = hint: use `import Robot (setVelTR)`
  
  1 error
  [1]

  $ cat > include.frob <<'FROB'
  > #include "Robot.h"
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.1[m/s] 0))
  > FROB
  $ frobc check include.frob
  error[E0103]: unexpected character `#`
   --> include.frob:1:1
    |
  1 | #include "Robot.h"
    | ^
    |
    = hint: to import a Frob module, write its name: `import Robot`; for your own C code, write `foreign include "Robot.h"`
  
  1 error
  [1]

  $ cat > extern.frob <<'FROB'
  > extern "C" double filter(double x);
  > main :: SF Float Float
  > main = proc x -> filter x
  > FROB
  $ frobc check extern.frob
  error[E0110]: Frob has no `extern`
   --> extern.frob:1:1
    |
  1 | extern "C" double filter(double x);
    | ^^^^^^
    |
    = hint: declare a C function with its Frob type and its C name: `foreign cubeRoot :: Float -> Float = "cbrt"`
  
  1 error
  [1]

An equation among the statements of a task:

  $ cat > equation.frob <<'FROB'
  > import Robot
  > main = reactimateTask (do
  >     ok = forward 1[m]
  >     if ok then turnBy 90[deg] else return ())
  > FROB
  $ frobc check equation.frob
  error[E0110]: expected `<-`, `-<`, or the end of this statement, found `=`
   --> equation.frob:3:8
    |
  3 |     ok = forward 1[m]
    |        ^
    |
    = hint: for the result of a task, write `ok <- forward 1[m]`; for a value, write `let ok = forward 1[m]`
  
  1 error
  [1]

  $ cat > previous.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> y where
  >     y = 0.9 * prev y + 0.1 * x
  > FROB
  $ frobc check previous.frob
  error[E0205]: unknown name `prev`
   --> previous.frob:3:15
    |
  3 |     y = 0.9 * prev y + 0.1 * x
    |               ^^^^
    |
    = hint: write `delay 0 y`, where 0 is the value at the first instant
  
  1 error
  [1]

  $ cat > no_text.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.1[m/s] 0) where
  >     assert (frontSonar i > 0.1[m]))
  > FROB
  $ frobc check no_text.frob
  error[E0110]: an `assert` needs a label that describes its condition
   --> no_text.frob:3:5
    |
  3 |     assert (frontSonar i > 0.1[m]))
    |     ^^^^^^
    |
    = hint: write `assert "keeps off the wall" (frontSonar i > 0.1[m])`
  
  1 error
  [1]
