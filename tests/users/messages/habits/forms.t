Constructs of other languages: the message shows Frob's syntax, with the
program's own words.

A list comprehension:

  $ cat > comprehension.frob <<'FROB'
  > ds = [0.1[m], 0.2[m]]
  > twice = [2 * d | d <- ds]
  > FROB
  $ frobc check comprehension.frob
  error[E0110]: expected an operator, `,` and another element, or `]`, found `|`
   --> comprehension.frob:2:16
    |
  2 | twice = [2 * d | d <- ds]
    |                ^
    |
    = hint: use `map (\d -> 2 * d) ds` to compute each element
  
  1 error
  [1]
  $ sed 's/\[2.*/map (\\d -> 2 * d) ds/' comprehension.frob > mapped.frob
  $ frobc check mapped.frob

An equation before the guards:

  $ cat > guards.frob <<'FROB'
  > speed d =
  >     | d < 0.3[m] = 0
  >     | otherwise = 0.3[m/s]
  > FROB
  $ frobc check guards.frob
  error[E0110]: expected the value of the definition after `=`, found `|`
   --> guards.frob:2:5
    |
  2 |     | d < 0.3[m] = 0
    |     ^
    |
    = hint: remove the `=` before the guards: each guard has its own, as in `| x > 0 = 1`
  
  1 error
  [1]
  $ sed 's/ =$//' guards.frob > equations.frob
  $ frobc check equations.frob

A `case` without `of`, as in Python:

  $ cat > case.frob <<'FROB'
  > speed m = case m:
  >     True -> 0
  >     False -> 0.3[m/s]
  > FROB
  $ frobc check case.frob
  error[E0103]: unexpected character `:`
   --> case.frob:1:17
    |
  1 | speed m = case m:
    |                 ^
    |
    = hint: end the line of a `case` with `of`: `case x of`
  
  1 error
  [1]
  $ cat > blank.frob <<'FROB'
  > speed m = case m
  >     True -> 0
  >     False -> 0.3[m/s]
  > FROB
  $ frobc check blank.frob
  error[E0110]: expected `of` after the expression of the `case`, found `->`
   --> blank.frob:2:10
    |
  1 | speed m = case m
    |           ---- this `case`
  2 |     True -> 0
    |          ^^
    |
    = hint: end the line of the `case` with `of`: `case m of`
  
  1 error
  [1]

`==` for a definition, and `=` after the input of a `proc`:

  $ cat > equal.frob <<'FROB'
  > speed == 0.3[m/s]
  > FROB
  $ frobc check equal.frob
  error[E0110]: expected `=` after the left-hand side of a definition, found the end of the file
   --> equal.frob:1:18
    |
  1 | speed == 0.3[m/s]
    |                  ^
    |
    = hint: write a single `=` to define a name, as in `speed = …`; `==` compares two values
  
  1 error
  [1]
  $ cat > input.frob <<'FROB'
  > half = proc x = x / 2
  > FROB
  $ frobc check input.frob
  error[E0110]: expected `->` after the input of this `proc`, found `=`
   --> input.frob:1:15
    |
  1 | half = proc x = x / 2
    |               ^
    |
    = hint: write `->` between the input and the output; `=` is for equations
  
  1 error
  [1]

Names with a capital, of a value (reported once, however often it is used) and of a field:

  $ cat > capital.frob <<'FROB'
  > Speed = 0.3[m/s]
  > twice = 2 * Speed
  > FROB
  $ frobc check capital.frob
  error[E0226]: a top-level definition defines one name, not a pattern
   --> capital.frob:1:1
    |
  1 | Speed = 0.3[m/s]
    | ^^^^^^^^^^^^^^^^
    |
    = hint: start the name of a value with a lower-case letter: `speed`
  
  1 error
  [1]
  $ cat > field.frob <<'FROB'
  > import Geometry
  > goal = Vec2 { X = 1[m], y = 0 }
  > FROB
  $ frobc check field.frob
  error[E0110]: expected the name of a field, found `X`
   --> field.frob:2:15
    |
  2 | goal = Vec2 { X = 1[m], y = 0 }
    |               ^
    |
    = hint: start the name of a field with a lower-case letter: `x`
  
  1 error
  [1]

A unit without brackets is recognized as a whole:

  $ cat > unit.frob <<'FROB'
  > slope = 0.3m/s^2 * 2
  > FROB
  $ frobc check unit.frob
  error[E0105]: the number `0.3` is directly followed by `m/s^2`
   --> unit.frob:1:9
    |
  1 | slope = 0.3m/s^2 * 2
    |         ^^^^^^^^
    |
    = hint: put the unit in brackets: `0.3[m/s^2]`
  
  1 error
  [1]

A bracket that is closed too late: the outer one stays open.

  $ cat > late.frob <<'FROB'
  > half x = (0.5 * (x - 1)
  > FROB
  $ frobc check late.frob
  error[E0111]: this `(` is never closed
   --> late.frob:1:10
    |
  1 | half x = (0.5 * (x - 1)
    |          ^             - a `)` is probably missing here
    |
    = hint: write `(0.5 * (x - 1))`
  
  1 error
  [1]

A choice between commands, with the signal function that the branches contain:

  $ cat > choice.frob <<'FROB'
  > speed = proc d -> do
  >     if d < 0.5[m]
  >       then returnA -< 0
  >       else returnA -< 0.3[m/s]
  > FROB
  $ frobc check choice.frob
  error[E0116]: `if` and `case` cannot choose between commands
   --> choice.frob:3:20
    |
  2 |     if d < 0.5[m]
    |     -- this chooses between commands
  3 |       then returnA -< 0
    |                    ^^
    |
    = hint: choose the input, as in `returnA -< if c then a else b`, or run both commands and choose between their outputs
  
  1 error
  [1]
