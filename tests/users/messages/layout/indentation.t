For a line that starts in a wrong column, the message says where its block
starts.

  $ cat > left.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> y where
  >     y = x + z
  >    z = 2
  > FROB
  $ frobc check left.frob
  error[E0110]: expected an operator, an argument, or the end of this definition, found `z`
   --> left.frob:4:4
    |
  4 |    z = 2
    |    ^
    |
    = hint: the definitions of this block start at column 5, but this line starts at column 4
  
  1 error
  [1]

  $ cat > right.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> y where
  >     y = x + z
  >       z = 2
  > FROB
  $ frobc check right.frob
  error[E0110]: expected an operator, an argument, or the end of this definition, found `=`
   --> right.frob:4:9
    |
  4 |       z = 2
    |         ^
    |
    = hint: this line is indented further than column 5, where the definitions of this block start, so it continues the line above; if you meant a separate line, start it at column 5
  
  1 error
  [1]

  $ cat > branches.frob <<'FROB'
  > f :: Bool -> Float
  > f b = case b of
  >     True -> 1
  >    False -> 0
  > FROB
  $ frobc check branches.frob
  error[E0110]: expected an operator, an argument, or the end of this definition, found `False`
   --> branches.frob:4:4
    |
  4 |    False -> 0
    |    ^^^^^
    |
    = hint: the branches of this block start at column 5, but this line starts at column 4
  
  1 error
  [1]

  $ cat > where.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> y
  > where
  >     y = x + 1
  > FROB
  $ frobc check where.frob
  error[E0110]: expected a definition, a signature or a declaration, found `where`
   --> where.frob:3:1
    |
  3 | where
    | ^^^^^
    |
    = hint: indent `where` and the lines below it, because they belong to the definition above
  
  1 error
  [1]

  $ cat > column_1.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> y where
  > y = x + 1
  > 
  > f :: Float -> Float
  > f x = case x of
  >     0 -> z where
  >     z = 1
  >     _ -> x
  > FROB
  $ frobc check column_1.frob
  error[E0110]: this `where` has no definitions
   --> column_1.frob:2:20
    |
  2 | main = proc x -> y where
    |                    ^^^^^
    |
    = hint: indent the definitions after `where` further than the definition that the `where` belongs to
  
  error[E0110]: this `where` has no definitions
   --> column_1.frob:7:12
    |
  7 |     0 -> z where
    |            ^^^^^
    |
    = hint: indent the definitions after `where` further than the definition that the `where` belongs to
  
  2 errors
  [1]

An unclosed bracket around a block: the message shows the bracket, and the parser continues with the
definitions after it.

  $ cat > unclosed.frob <<'FROB'
  > import Robot
  > main = reactimateTask (do
  >     sleepT 1[s] (roMake (setVelTR 0.3[m/s] 0))
  >     sleepT 1[s] (roMake (setVelTR 0 0))
  > 
  > speed :: Velocity
  > speed = 1 +
  > FROB
  $ frobc check unclosed.frob
  error[E0111]: this `(` is never closed
   --> unclosed.frob:2:23
    |
  2 | main = reactimateTask (do
    |                       ^
  3 |     sleepT 1[s] (roMake (setVelTR 0.3[m/s] 0))
  4 |     sleepT 1[s] (roMake (setVelTR 0 0))
    |                                        - a `)` is missing before this
  
  error[E0110]: expected an operand after the operator, found the end of the file
   --> unclosed.frob:7:12
    |
  7 | speed = 1 +
    |            ^
  
  2 errors
  [1]

A line that belongs in a `where`; an expression that continues too far to the left; a branch with
guards only.

  $ cat > equation.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> y
  >     y = x + 1
  > FROB
  $ frobc check equation.frob
  error[E0110]: expected an operator, an argument, or the end of this definition, found `=`
   --> equation.frob:3:7
    |
  3 |     y = x + 1
    |       ^
    |
    = hint: this line is indented further than column 1, where the definitions of this block start, so it continues the line above; if it is an equation, add `where` to that line: `main = proc x -> y where`
  
  1 error
  [1]

  $ cat > left.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> y where
  >     y = let z = x in
  >     z + 1
  > FROB
  $ frobc check left.frob
  error[E0110]: expected an expression after `in`, found the end of the definition
   --> left.frob:3:21
    |
  3 |     y = let z = x in
    |                     ^
    |
    = hint: to continue a definition on the next line, indent that line further than the first
  
  1 error
  [1]

  $ cat > guards.frob <<'FROB'
  > f :: Float -> Float
  > f x = case x of
  >     | x > 1 -> 1
  >     | otherwise -> 0
  > FROB
  $ frobc check guards.frob
  error[E0110]: expected a branch of the `case`, found `|`
   --> guards.frob:3:5
    |
  3 |     | x > 1 -> 1
    |     ^
    |
    = hint: write, for example, `Just x -> x`, or with a guard `_ | x > 1 -> x`
  
  1 error
  [1]
