Notations of Elm and Haskell, and names of infinity. The test pastes or applies each fix.

  $ cat > imports.frob <<'FROB'
  > import Robot exposing (..)
  > import Control exposing (limit)
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (proc i -> roMake (setVelTR (limit 0.3[m/s] (0.5[1/s] * frontSonar i)) 0))
  > FROB
  $ frobc check imports.frob 2>&1 | grep -e ^error -e hint
  error[E0110]: expected `as`, a list of names in parentheses, or the end of the import, found `exposing`
    = hint: remove `exposing (..)`: `import Robot` imports everything
  error[E0110]: expected `as`, a list of names in parentheses, or the end of the import, found `exposing`
    = hint: remove `exposing`: write `import Control (limit)`
  $ sed 's/ exposing (..)//; s/ exposing//' imports.frob > pasted.frob && frobc check pasted.frob

  $ cat > guards.frob <<'FROB'
  > zone :: Distance -> Int
  > zone d = if | d < 0.3[m] -> 0
  >             | d < 1[m]   -> 1
  >             | otherwise  -> 2
  > main :: SF Distance Int
  > main = arr zone
  > FROB
  $ frobc check guards.frob 2>&1 | grep -e ^error -e hint
  error[E0110]: expected a condition after `if`, found `|`
    = hint: remove `if`, and write guards before the `=`: `zone d | d < 0.3[m] = 0 | d < 1[m] = 1 | otherwise = 2`
  $ sed '2s/.*/zone d | d < 0.3[m] = 0 | d < 1[m] = 1 | otherwise = 2/; 3,4d' guards.frob > pasted.frob && frobc check pasted.frob

  $ cat > output.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> do
  >     old <- delay 0 -< y
  >     y   <- returnA -< old + 0.1 * (x - old)
  > FROB
  $ frobc check output.frob 2>&1 | grep -e ^error -e hint
  error[E0116]: the last statement of this `do` is its output, so it cannot bind a name
    = hint: end the `do` with its output, as in `returnA -< y`
  $ (cat output.frob; echo '    returnA -< y') > pasted.frob && frobc check pasted.frob
  $ printf 'main :: SF Float Float\nmain = proc x -> do\n    let y = 2 * x\n' > let.frob
  $ frobc check let.frob 2>&1 | grep -e ^error -e hint
  error[E0116]: the last statement of this `do` is a `let`, so it has no output
    = hint: end the `do` with its output, as in `returnA -< y`
  $ (cat let.frob; echo '    returnA -< y') > pasted.frob && frobc check pasted.frob

  $ cat > commas.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> y + z where
  >     y = 2 * x,
  >     z = 3 * x
  > FROB
  $ frobc check commas.frob 2>&1 | grep -e ^error -e hint
  error[E0110]: expected an operator, an argument, or the end of this definition, found `,`
    = hint: remove the comma: the line break ends the equation
  $ sed 's/,$//' commas.frob > pasted.frob && frobc check pasted.frob
  $ printf 'main :: SF Float Float\nmain = proc x -> y + z where\n    y = 2 * x, z = 3 * x\n' > commas.frob
  $ frobc check commas.frob 2>&1 | grep -e ^error -e hint
  error[E0110]: expected an operator, an argument, or the end of this definition, found `,`
    = hint: remove the comma, and write each equation on a line of its own
  $ printf 'main :: SF Float Float\nmain = proc x -> do\n    y <- integral -< x,\n    returnA -< y\n' > commas.frob
  $ frobc check commas.frob 2>&1 | grep -e ^error -e hint
  error[E0110]: expected an operator, an argument, or the end of this statement, found `,`
    = hint: remove the comma: the line break ends the statement

  $ cat > label.frob <<'FROB'
  > import Display
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (proc i -> roMake (setVelTR 0 0) where
  >     shown = draw (number ("gap " ++ show (frontSonar i)) (frontSonar i)))
  > FROB
  $ frobc check label.frob 2>&1 | grep -e ^error -e hint
  error[E0110]: Frob has no `++`
    = hint: `number` shows the label, the value and its unit: write `number "gap" (frontSonar i)`
  $ cat > pasted.frob <<'FROB'
  > import Display
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (proc i -> roMake (setVelTR 0 0 . draw (number "gap" (frontSonar i))))
  > FROB
  $ frobc check pasted.frob

  $ cat > infinite.frob <<'FROB'
  > smallest :: Array 2 Float -> Float
  > smallest xs = foldl min Inf xs
  > main :: SF Float Float
  > main = proc x -> smallest [x, infinity]
  > FROB
  $ frobc check infinite.frob 2>&1 | grep -e ^error -e hint
  error[E0206]: unknown constructor `Inf`
    = hint: use `(1 / 0)` for infinity
  error[E0205]: unknown name `infinity`
    = hint: use `(1 / 0)` for infinity
  $ sed 's/Inf /(1 \/ 0) /; s/infinity/(1 \/ 0)/' infinite.frob > pasted.frob && frobc check pasted.frob

  $ cat > units.frob <<'FROB'
  > reach :: Distance[cm]
  > reach = 30[cm]
  > isFar :: Distance -> Bool[m]
  > isFar d = d > reach
  > main :: SF Distance Bool
  > main = arr isFar
  > FROB
  $ frobc check units.frob 2>&1 | grep -e ^error -e hint
  error[E0216]: type `Distance` takes no unit
     = hint: write `Distance`, without the unit
  error[E0216]: type `Bool` takes no unit
    = hint: write `Bool`, without the unit
  $ frobc fix --all units.frob > /dev/null 2>&1; frobc check units.frob
