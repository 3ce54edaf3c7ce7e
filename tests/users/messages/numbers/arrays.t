Arrays of a different size, ranges, patterns of a different length.

  $ cat > ranges.frob <<'FROB'
  > import Robot
  > 
  > ns = [1..5]
  > 
  > main = reactimateRobot (proc _ -> roMake (setVelTR (0.1[m/s] * toFloat (ns ! 0)) 0))
  > FROB
  $ frobc check ranges.frob
  error[E0110]: Frob has no `..`
   --> ranges.frob:3:8
    |
  3 | ns = [1..5]
    |        ^^
    |
    = hint: Frob has no ranges: write the elements, `[1, 2, 3, 4, 5]`
  
  1 error
  [1]
  $ sed 's/1..5/1, 2, 3/' ranges.frob > cured.frob
  $ frobc check cured.frob

  $ cat > sizes.frob <<'FROB'
  > import Robot
  > 
  > gains = [0.5, 0.3, 0.2]
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (0.5[1/s] * sum (zipWith (\g d -> g * d) gains ds)) 0) where
  >     ds = [frontSonar i, sideSonar i])
  > FROB
  $ frobc check sizes.frob
  error[E0301]: expected `Array 3 Float[u]`, found `Array 2 Distance`
   --> sizes.frob:5:99
    |
  5 | main = reactimateRobot (proc i -> roMake (setVelTR (0.5[1/s] * sum (zipWith (\g d -> g * d) gains ds)) 0) where
    |                                                                     -------                 ----- ^^
    |                                                                     |                       |
    |                                                                     |                       because this is `Array 3 Float`
    |                                                                     argument 3 of `zipWith` is `Array 3 Float[u]`
    |
    = hint: use `take` or `drop` to change the size of an array; the type of the result gives the new size
  
  1 error
  [1]
  $ sed 's/sideSonar i]/sideSonar i, rightSonar i]/' sizes.frob > cured.frob
  $ frobc check cured.frob

  $ cat > pattern.frob <<'FROB'
  > import Robot
  > 
  > sides :: SF RobotInput (Distance, Distance)
  > sides = proc i -> (sideSonar i, rightSonar i)
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (0.5[1/s] * f) 0) where
  >     (f, l, r) = sides i)
  > FROB
  $ frobc check pattern.frob
  error[E0301]: expected a tuple with 3 elements, found one with 2
   --> pattern.frob:7:17
    |
  7 |     (f, l, r) = sides i)
    |     ---------   ^^^^^^^ this is `(Distance, Distance)`
    |     |
    |     the pattern matches `(a, b, c)`
    |
    = hint: write the pattern as `(a, b)`
  
  1 error
  [1]
  $ sed 's/(f, l, r)/(f, _)/' pattern.frob > cured.frob
  $ frobc check cured.frob
