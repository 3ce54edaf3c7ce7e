Syntax that C and Python write differently: the message shows Frob's syntax.

  $ cat > differs.frob <<'FROB'
  > f :: Float -> Bool
  > f x = x != 0
  > FROB
  $ frobc check differs.frob
  error[E0110]: Frob has no `!=`
   --> differs.frob:2:9
    |
  2 | f x = x != 0
    |         ^^
    |
    = hint: use `/=` to compare for inequality
  
  1 error
  [1]

  $ cat > not.frob <<'FROB'
  > f :: Bool -> Bool
  > f x = !x
  > FROB
  $ frobc check not.frob
  error[E0110]: Frob has no prefix `!`
   --> not.frob:2:7
    |
  2 | f x = !x
    |       ^
    |
    = hint: write `not x`
  
  1 error
  [1]

  $ cat > and.frob <<'FROB'
  > f :: Bool -> Bool -> Bool
  > f x y = x & y
  > FROB
  $ frobc check and.frob
  error[E0103]: unexpected character `&`
   --> and.frob:2:11
    |
  2 | f x y = x & y
    |           ^
    |
    = hint: write `&&`, or `.&.` for bits
  
  1 error
  [1]

  $ cat > comment.frob <<'FROB'
  > // the speed
  > speed = 1
  > FROB
  $ frobc check comment.frob
  error[E0110]: Frob has no `//`
   --> comment.frob:1:1
    |
  1 | // the speed
    | ^^
    |
    = hint: write `--` to start a comment
  
  1 error
  [1]

  $ cat > chain.frob <<'FROB'
  > f :: Float -> Float
  > f x = if x > 0 then 1 elif x < 0 then 2 else 3
  > FROB
  $ frobc check chain.frob
  error[E0110]: Frob has no `elif`
   --> chain.frob:2:23
    |
  2 | f x = if x > 0 then 1 elif x < 0 then 2 else 3
    |                       ^^^^
    |
    = hint: use `else if`: `if a then x else if b then y else z`
  
  1 error
  [1]

  $ cat > between.frob <<'FROB'
  > inside :: Float -> Float -> Float -> Bool
  > inside a b c = a < b < c
  > FROB
  $ frobc check between.frob
  error[E0113]: `<` and `<` cannot be combined without parentheses
   --> between.frob:2:22
    |
  2 | inside a b c = a < b < c
    |                  -   ^
    |                  |
    |                  after this one
    |
    = hint: compare two values at a time: `a < b && b < c`
  
  1 error
  [1]

  $ cat > assign.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> n where
  >     n += x
  > FROB
  $ frobc check assign.frob
  error[E0110]: Frob has no `+=`
   --> assign.frob:3:7
    |
  3 |     n += x
    |       ^^
    |
    = hint: Frob has no assignments: write an equation that holds at every instant: `n = delay 0 n + x`, where 0 is the initial value
  
  1 error
  [1]

Braces have one message, not one for each.

  $ cat > braces.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> y where {
  >     y = x;
  > }
  > FROB
  $ frobc check braces.frob
  error[E0110]: expected a definition or a signature, found `{`
   --> braces.frob:2:26
    |
  2 | main = proc x -> y where {
    |                          ^
    |
    = hint: remove the braces, which are only for records: `y = x`
  
  1 error
  [1]

  $ cat > words.frob <<'FROB'
  > inside :: Float -> Bool
  > inside x = x > 0 and x < 1
  > FROB
  $ frobc check words.frob
  error[E0110]: Frob has no `and`
   --> words.frob:2:18
    |
  2 | inside x = x > 0 and x < 1
    |                  ^^^
    |
    = hint: write `&&` instead of `and`
  
  1 error
  [1]

  $ cat > call.frob <<'FROB'
  > import Control
  > f :: Float -> Float
  > f x = limit(1, x)
  > FROB
  $ frobc check call.frob
  error[E0301]: expected a number, found a tuple with 2 elements
   --> call.frob:3:12
    |
  3 | f x = limit(1, x)
    |       -----^^^^^^
    |       |
    |       argument 1 of `limit` is a number
    |
    = hint: write the arguments without parentheses or commas: `limit 1 x`
  
  1 error
  [1]

An `if` without `else` among the statements of a task.

  $ cat > one_armed.frob <<'FROB'
  > act :: Task Float Float ()
  > act = do
  >     if True then sleepT 1[s] 2
  >     sleepT 1[s] 3
  > main :: SF Float (Either Float ())
  > main = runTask act
  > FROB
  $ frobc check one_armed.frob
  error[E0110]: expected `else` after the first branch, found the end of the statement
   --> one_armed.frob:3:31
    |
  3 |     if True then sleepT 1[s] 2
    |                               ^
    |
    = hint: to run a task only if a condition holds, write `whenT True (sleepT 1[s] 2)`; to choose between two tasks, add an `else`
  
  1 error
  [1]
  $ sed 's/if True then \(.*\)/whenT True (\1)/' one_armed.frob > when.frob && frobc check when.frob
  $ sed 's/if True.*/& else return ()/' one_armed.frob > else.frob && frobc check else.frob

Comments and counting as in C.

  $ cat > starred.frob <<'FROB'
  > main :: SF Float Float
  > main = identity /* nothing */
  > FROB
  $ frobc check starred.frob
  error[E0110]: Frob has no `/*`
   --> starred.frob:2:17
    |
  2 | main = identity /* nothing */
    |                 ^^
    |
    = hint: write a comment as `{- … -}`, or as `-- …` to the end of the line
  
  1 error
  [1]

  $ cat > counted.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> n where
  >     n = x++
  > FROB
  $ frobc check counted.frob
  error[E0110]: Frob has no `++`
   --> counted.frob:3:10
    |
  3 |     n = x++
    |          ^^
    |
    = hint: Frob has no assignments: write an equation that holds at every instant: `x = delay 0 x + 1`, where 0 is the initial value
  
  1 error
  [1]
