The syntax of other languages. Each message offers the line in Frob, and the test pastes it.

Calls within calls:

  $ cat > calls.frob <<'FROB'
  > main :: SF (Float, Float) Float
  > main = proc (a, b) -> max(0, min(a + 1, b))
  > FROB
  $ frobc check calls.frob 2>&1 | grep -e ^error -e hint
  error[E0301]: `max` takes 2 arguments, but is given one tuple
    = hint: write the arguments without parentheses or commas: `max 0 (min (a + 1) b)`
  $ sed 's/max(0.*/max 0 (min (a + 1) b)/' calls.frob > pasted.frob && frobc check pasted.frob

A missing bracket inside an expression, and a superfluous one:

  $ cat > bracket.frob <<'FROB'
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (proc i -> roMake (setVelTR (0.5[1/s] * (frontSonar i - 0.4[m]) 0))
  > FROB
  $ frobc check bracket.frob
  error[E0111]: this `(` is never closed
   --> bracket.frob:3:52
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR (0.5[1/s] * (frontSonar i - 0.4[m]) 0))
    |                                                    ^                                  - a `)` is probably missing here
    |
    = hint: write `setVelTR (0.5[1/s] * (frontSonar i - 0.4[m])) 0`
  
  1 error
  [1]
  $ sed 's/setVelTR.*/setVelTR (0.5[1\/s] * (frontSonar i - 0.4[m])) 0))/' bracket.frob > pasted.frob && frobc check pasted.frob
  $ printf 'main :: SF Float Float\nmain = proc x -> 2 * max 0 (x + 1\n' > end.frob
  $ frobc check end.frob 2>&1 | grep -e ^error -e hint
  error[E0111]: this `(` is never closed
    = hint: write `(x + 1)`
  $ printf 'main :: SF Float Float\nmain = proc x -> max 0 (x + 1))\n' > surplus.frob
  $ frobc check surplus.frob 2>&1 | grep -e ^error -e hint
  error[E0111]: this `)` has no opening bracket
    = hint: remove it, or add a `(` before it: all other brackets in this definition are closed
  $ frobc fix --all surplus.frob > /dev/null 2>&1; frobc check surplus.frob

Functions of C, Python and MATLAB:

  $ cat > function.frob <<'FROB'
  > #include <stdio.h>
  > float twice(float x) { return fabs(x) * 2; }
  > main :: SF Float Float
  > main = arr twice
  > FROB
  $ frobc check function.frob 2>&1 | grep -e ^error -e hint
  error[E0103]: unexpected character `#`
    = hint: remove it: functions such as `sqrt` and `sin` are built in; import other modules by name, as in `import Robot`
  error[E0110]: this function definition is not valid Frob syntax
    = hint: write a signature, `twice :: Float -> Float`, and below it an equation, `twice x = abs x * 2`
  $ sed '1d; 2s/.*/twice :: Float -> Float\ntwice x = abs x * 2/' function.frob > pasted.frob && frobc check pasted.frob
  $ cat > count.frob <<'FROB'
  > int count(int n, int m)
  > {
  >     return n + m;
  > }
  > FROB
  $ frobc check count.frob 2>&1 | grep -e ^error -e hint
  error[E0110]: this function definition is not valid Frob syntax
    = hint: write a signature, `count :: Int -> Int -> Int`, and below it an equation, `count n m = n + m`
  $ printf 'def twice(x, k=2):\n    return k * x\n' > def.frob
  $ frobc check def.frob 2>&1 | grep -e ^error -e hint
  error[E0103]: unexpected character `:`
    = hint: define a function by an equation: `twice x k = k * x`
  $ printf 'function y = twice(x)\n  y = x * 2;\nend\n' > matlab.frob
  $ frobc check matlab.frob 2>&1 | grep -e ^error -e hint
  error[E0110]: Frob has no `function`
    = hint: define a function by an equation: `twice x = x * 2`; a block ends where its indentation ends

Anonymous functions:

  $ for f in 'x -> x * 2' 'x => max(x, 2)' 'lambda x: x * 2' '@(x) x * 2'; do
  >   printf 'main :: SF Float Float\nmain = arr (%s)\n' "$f" > anonymous.frob
  >   frobc check anonymous.frob 2>&1 | grep hint
  > done
    = hint: write an anonymous function as `\x -> x * 2`, or a signal function as `proc x -> …`
    = hint: write an anonymous function as `\x -> max x 2`, or a signal function as `proc x -> …`
    = hint: write an anonymous function as `\x -> x * 2`
    = hint: write an anonymous function as `\x -> x * 2`
  $ printf 'main :: SF Float Float\nmain = arr (\\x -> max x 2)\n' > pasted.frob && frobc check pasted.frob

Conditions:

  $ for f in 'x > 0 and x < 1' 'x > 0 | x < 1' 'x > 0 OR x < 1' '!(x > 0)' 'x === 0' 'x > 0 &&& x < 1' 'x is 0'; do
  >   printf 'main :: SF Float Bool\nmain = proc x -> %s\n' "$f" > condition.frob
  >   frobc check condition.frob 2>&1 | grep -e ^error -e hint
  > done
  error[E0110]: Frob has no `and`
    = hint: write `&&` instead of `and`
  error[E0110]: Frob has no `|` operator
    = hint: write `||` between two conditions
  error[E0110]: Frob has no `OR`
    = hint: write `||` instead of `OR`
  error[E0110]: Frob has no prefix `!`
    = hint: write `not (x > 0)`
  error[E0110]: Frob has no `===`
    = hint: use `==` to compare
  error[E0301]: `&&&` combines signal functions, but this is a condition
    = hint: to combine two conditions, write `&&`
  error[E0205]: Frob has no `is`
    = hint: write `==` instead of `is`
  $ for f in 'x > 0 && x < 1' 'x > 0 || x < 1' 'not (x > 0)' 'x == 0'; do
  >   printf 'main :: SF Float Bool\nmain = proc x -> %s\n' "$f" > pasted.frob && frobc check pasted.frob
  > done

Choices:

  $ cat > choice.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> y where
  >     if x > 1:
  >         y = 1
  >     elif x < 0 and x > -1:
  >         y = 0
  >     else:
  >         y = x
  > FROB
  $ frobc check choice.frob 2>&1 | grep -e ^error -e hint
  error[E0103]: unexpected character `:`
    = hint: choose the value in one equation: `y = if x > 1 then 1 else if x < 0 && x > -1 then 0 else x`
  $ printf 'main :: SF Float Float\nmain = proc x -> y where\n    y = if x > 1 then 1 else if x < 0 && x > -1 then 0 else x\n' > pasted.frob && frobc check pasted.frob
  $ for f in 'if (x > 1) { y = 1; } else { y = 0; }' 'y = if (x > 1) { 1 } else { 0 }' 'y = x > 1 ? 1 : 0' 'y = 1 if x > 1 else 0'; do
  >   printf 'main :: SF Float Float\nmain = proc x -> y where\n    %s\n' "$f" > choice.frob
  >   frobc check choice.frob 2>&1 | grep hint
  > done
    = hint: choose the value in one equation: `y = if x > 1 then 1 else 0`
    = hint: use `if (x > 1) then 1 else 0`, without braces
    = hint: use `if x > 1 then 1 else 0`
    = hint: use `if x > 1 then 1 else 0`
  $ printf 'main :: SF Float Float\nmain = proc x -> y where\n    y = if x > 1 then 1 else 0\n' > pasted.frob && frobc check pasted.frob

Assignments and declarations:

  $ for f in 'y += x' 'y++' 'y :: Float = x' 'y = z = x' 'a, y = (x, x)' 'var y = x' 'float y[2] = {1, 0.5};'; do
  >   printf 'main :: SF Float Float\nmain = proc x -> y where\n    %s\n' "$f" > assignment.frob
  >   frobc check assignment.frob 2>&1 | grep hint
  > done
    = hint: Frob has no assignments: write an equation that holds at every instant: `y = delay 0 y + x`, where 0 is the initial value
    = hint: Frob has no assignments: write an equation that holds at every instant: `y = delay 0 y + 1`, where 0 is the initial value
    = hint: write the definition on its own line, below its type: `y = x`
    = hint: write an equation for each name, `z = x` and below it `y = z`; to compare, write `==`
    = hint: put a tuple pattern in parentheses: `(a, y) = (x, x)`
    = hint: remove `var` before `y`
    = hint: write `y :: Array 2 Float`, and below it `y = [1, 0.5]`
  $ printf 'main :: SF Float Float\nmain = proc x -> y where\n    y = delay 0 y + x\n' > pasted.frob && frobc check pasted.frob

Braces and semicolons:

  $ cat > braces.frob <<'FROB'
  > data P = P { a :: Float; b :: Float }
  > main :: SF Float P
  > main = proc x -> P { a = y, b = z } where { y = x; z = 2 }
  > FROB
  $ frobc check braces.frob 2>&1 | grep -e ^error -e hint
  error[E0111]: fields are separated by `,`, not by `;`
    = hint: write `{ a :: Float, b :: Float }`
  error[E0110]: expected a definition or a signature, found `{`
    = hint: write it without braces, each part on a line of its own: `y = x`, and below it `z = 2`
  $ sed 's/; b/, b/; s/ where.*/ where\n    y = x\n    z = 2/' braces.frob > pasted.frob && frobc check pasted.frob
  $ printf 'struct P { float a; int n; };\nenum Side { Left, Right };\n' > struct.frob
  $ frobc check struct.frob 2>&1 | grep hint
    = hint: declare a record with `data` and a constructor: `data P = P { a :: Float, n :: Int }`
    = hint: declare an enumeration with `data`: `data Side = Left | Right`
  $ printf 'data P = P { a :: Float, n :: Int }\ndata Side = Left | Right\nmain :: SF Float Float\nmain = arr id\n' > pasted.frob && frobc check pasted.frob

Elements, units and numbers:

  $ for f in '0.5 * xs[n + 1]' '5. * xs ! 0' 'pow(xs ! 0, 2)' '(xs ! 0)(2 + 1)' '2 * xs.size()'; do
  >   printf 'main :: SF (Array 3 Float, Int) Float\nmain = proc (xs, n) -> %s\n' "$f" > number.frob
  >   frobc check number.frob 2>&1 | grep hint
  > done
    = hint: write `(at (n + 1) 0 xs)` for the element at a computed index; 0 is the value if there is no such element
    = hint: write a digit after the decimal point: `5.0`
    = hint: write a power as `x ** y`, or as `x ^ 2` if the exponent is a literal
    = hint: `! :: Array n a -> Int -> a`
    = hint: `length` is a function: write `length xs`
  $ printf 'main :: SF (Array 3 Float, Int) Float\nmain = proc (xs, n) -> 0.5 * (at (n + 1) 0 xs)\n' > pasted.frob && frobc check pasted.frob
  $ for f in '0.5 m/s' '0.5 [m/s]' '0.5m/s'; do
  >   printf 'main :: SF Float Velocity\nmain = proc x -> x * %s\n' "$f" > unit.frob
  >   frobc check unit.frob 2>&1 | grep -e ^error -e hint
  >   frobc fix --all unit.frob > /dev/null 2>&1; frobc check unit.frob
  > done
  error[E0205]: the unit `m/s` needs brackets
    = hint: write it directly after its number: `0.5[m/s]`
  error[E0110]: a unit must directly follow its number, without a space
    = hint: remove the space: `0.5[m/s]`
  error[E0105]: the number `0.5` is directly followed by `m/s`
    = hint: put the unit in brackets: `0.5[m/s]`

Steps of a task:

  $ cat > steps.frob <<'FROB'
  > import Robot
  > act :: Task RobotInput RobotOutput ()
  > act = do
  >     ok <- forward 1[m]
  >     if ok then turnBy 90[deg]
  > main :: Program RobotInput RobotOutput
  > main = reactimateTask act
  > FROB
  $ frobc check steps.frob 2>&1 | grep -e ^error -e hint
  error[E0110]: expected `else` after the first branch, found the end of the block
    = hint: to run a task only if a condition holds, write `whenT ok (turnBy 90[deg])`; to choose between two tasks, add an `else`
  $ sed 's/if ok then turnBy 90.deg./whenT ok (turnBy 90[deg])/' steps.frob > pasted.frob && frobc check pasted.frob
