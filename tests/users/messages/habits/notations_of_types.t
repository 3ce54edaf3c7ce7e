Types and signal functions in the notation of other languages. Each program is one definition; the
test shows the message without the source, and checks the definition with which the hint replaces
it.

  $ try () { # DEFINITION CORRECTED-DEFINITION
  >   printf 'import Robot\n%s\n' "$1" > program.frob
  >   frobc check program.frob 2>&1 | grep '^error\|hint'
  >   printf 'import Robot\n%s\n' "$2" > corrected.frob
  >   frobc check corrected.frob 2>&1 | grep '^error'
  > }

  $ try 'rest :: SF RobotInput -> RobotOutput
  > rest = proc _ -> restingOutput' 'rest :: SF RobotInput RobotOutput
  > rest = proc _ -> restingOutput'
  error[E0216]: type `SF` takes 2 type arguments, not 1
    = hint: write `SF RobotInput RobotOutput`, without an arrow between the input and the output
  [1]

  $ try 'braked :: Float m/s -> Velocity
  > braked v = v' 'braked :: Float[m/s] -> Velocity
  > braked v = v'
  error[E0110]: expected `->` or the end of the type after a type variable, found `/`
    = hint: a unit in a type needs brackets: `Float[m/s]`
  [1]

  $ try 'type Row = [Distance]' 'type Row = Array 5 Distance'
  error[E0110]: expected a type after `=`, found `[`
    = hint: Frob has arrays with a fixed number of elements: write `Array 5 Distance`, and replace 5 with your number
  [1]

  $ try 'meter :: SF Velocity Distance
  > meter = proc v => integral v' 'meter :: SF Velocity Distance
  > meter = proc v -> integral v'
  error[E0110]: expected an operator, an argument, or the end of the expression, found `=>`
    = hint: write `->` after the input of a `proc`: `proc v ->`
  [1]
