Hints that show the user's own line instead of an example. The test pastes or applies each fix.

  $ cat > product.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> weighted [0.2, 0.8] [x, 2 * x]
  > weighted :: Array 2 Float -> Array 2 Float -> Float
  > weighted w x = sum (w .* x)
  > FROB
  $ frobc check product.frob 2>&1 | grep -e ^error -e hint
  error[E0110]: Frob has no `.*`
    = hint: operators take numbers, not arrays: write `w * x` for numbers, or `zipWith (*) w x` for arrays
  $ sed 's/w \.\* x/zipWith (*) w x/' product.frob > pasted.frob && frobc check pasted.frob

  $ cat > mapped.frob <<'FROB'
  > main :: SF Bool (Event Int)
  > main = proc pressed -> (\n -> 2 * n) <$> count press where
  >     press = edge pressed
  > FROB
  $ frobc check mapped.frob 2>&1 | grep -e ^error -e hint
  error[E0110]: Frob has no `<$>`
    = hint: write `mapE (\n -> 2 * n) (count press)` for an event, or `map (\n -> 2 * n) (count press)` for an array
  $ sed 's/-> (.*press where/-> mapE (\\n -> 2 * n) (count press) where/' mapped.frob > pasted.frob && frobc check pasted.frob
  $ printf 'twice :: Array 2 Int -> Array 2 Int\ntwice xs = map (\\x -> 2 * x) (negate <$> xs)\n' > mapped.frob
  $ frobc check mapped.frob 2>&1 | grep -e ^error -e hint
  error[E0110]: Frob has no `<$>`
    = hint: write `mapE negate xs` for an event, or `map negate xs` for an array

  $ cat > number.frob <<'FROB'
  > double :: Num a => a -> a
  > double x = x + x
  > half :: (Fractional a) => a -> a
  > half x = x / 2
  > larger :: (Num a, Ord a) => a -> a -> a
  > larger x y = if x > y then x else y
  > main :: SF Velocity Velocity
  > main = proc v -> double (half v)
  > FROB
  $ frobc check number.frob 2>&1 | grep -e ^error -e hint
  error[E0223]: unknown type class `Num`
    = hint: Frob has no numeric type classes: write `double :: n[u] -> n[u]`
  error[E0223]: unknown type class `Fractional`
    = hint: Frob has no numeric type classes: write `half :: Float[u] -> Float[u]`
  error[E0223]: unknown type class `Num`
    = hint: Frob has no numeric type classes: write `n[u]` for an Int or a Float with any unit, as in `twice :: n[u] -> n[u]`, or `Float[u]` for a Float only
  $ sed 's/Num a => a -> a/n[u] -> n[u]/; s/(Fractional a) => a -> a/Float[u] -> Float[u]/; /^larger/d' number.frob > pasted.frob && frobc check pasted.frob

  $ cat > tour.frob <<'FROB'
  > import Geometry
  > import Robot
  > main = reactimateTask (mapM_ driveTo places)
  > places :: Array 2 Point2
  > places = [Vec2 { x = 1[m], y = 0 }, zeroVec]
  > FROB
  $ frobc check tour.frob 2>&1 | grep -e ^error -e hint
  error[E0205]: unknown name `mapM_`
    = hint: write `forEachT places driveTo`, which runs the tasks one after the other
  $ frobc fix --all tour.frob > /dev/null 2>&1; frobc check tour.frob

  $ cat > sizes.frob <<'FROB'
  > prepend :: a -> Array n a -> Array (n + 1) a
  > prepend x xs = generate (\k -> at (k - 1) x xs)
  > main :: SF Float (Array 4 Float)
  > main = proc x -> prepend x [1, 2, 3]
  > FROB
  $ frobc check sizes.frob 2>&1 | grep -e ^error -e hint
  error[E0330]: `n` is a variable, but arithmetic on sizes needs known numbers
    = hint: use another variable for the result, as in `prepend :: a -> Array n a -> Array k a`
  $ sed 's/(n + 1)/k/' sizes.frob > pasted.frob && frobc check pasted.frob

  $ cat > logarithm.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> 20 * log10 (abs x + 1) - log2 2
  > FROB
  $ frobc check logarithm.frob 2>&1 | grep -e ^error -e hint
  error[E0205]: unknown name `log10`
    = hint: write `log (abs x + 1) / log 10`, because `log` is the natural logarithm
  error[E0205]: unknown name `log2`
    = hint: write `log 2 / log 2`, because `log` is the natural logarithm
  $ frobc fix --all logarithm.frob > /dev/null 2>&1; tail -1 logarithm.frob; frobc check logarithm.frob
  main = proc x -> 20 * (log (abs x + 1) / log 10) - (log 2 / log 2)

  $ cat > slope.frob <<'FROB'
  > main :: SF Distance Velocity
  > main = proc e -> 0.1 * slope where
  >     slope = (e - delay 0 e) / dt
  > FROB
  $ frobc check slope.frob 2>&1 | grep -e ^error -e hint
  error[E0205]: unknown name `dt`
    = hint: write `derivative e` instead of `(e - delay 0 e) / dt`
  $ frobc fix --all slope.frob > /dev/null 2>&1; frobc check slope.frob

  $ cat > commas.frob <<'FROB'
  > main :: SF Distance (Array 3 Float, Array 2 Distance)
  > main = proc d -> ([0.5 0.3 0.2], [2[m] d])
  > FROB
  $ frobc check commas.frob 2>&1 | grep -e ^error -e hint
  error[E0302]: this is `Float`, not a function
    = hint: put commas between the elements: `[0.5, 0.3, 0.2]`
  error[E0302]: this is a number in `m`, not a function
    = hint: put commas between the elements: `[2[m], d]`
  $ frobc fix --all commas.frob > /dev/null 2>&1; frobc check commas.frob

  $ cat > continuation.frob <<'FROB'
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot dash
  > dash :: SF RobotInput RobotOutput
  > dash = switch
  >     (proc _ -> (roMake (setVelTR 0.3[m/s] 0), after 5[s] ()))
  >     (\_ -> roMake (setVelTR 0 0))
  > FROB
  $ frobc check continuation.frob
  error[E0360]: a signal function is needed here, but `roMake` returns an output
   --> continuation.frob:7:12
    |
  7 |     (\_ -> roMake (setVelTR 0 0))
    |            ^^^^^^
    |
    = hint: for a signal function that always returns this output, write `constant (roMake (setVelTR 0 0))`
  
  1 error
  [1]
  $ frobc fix --all continuation.frob > /dev/null 2>&1; frobc check continuation.frob
