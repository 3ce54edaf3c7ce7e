Arrays of another size, ranges, patterns of another length.

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
    = hint: there are no ranges: a few elements are written out, `[1, 2, 3]`; many are made by the index, `generate (\i -> i + 1)`, as many as the type says
  
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
    = hint: the two have different numbers of elements; `take` and `drop` make an array of the size that its type says
  
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
  error[E0301]: expected a tuple of 3, found one of 2
   --> pattern.frob:7:17
    |
  7 |     (f, l, r) = sides i)
    |     ---------   ^^^^^^^ this is `(Distance, Distance)`
    |     |
    |     the pattern takes `(a, b, c)`
    |
    = hint: a pattern for it is `(a, b)`
  
  1 error
  [1]
  $ sed 's/(f, l, r)/(f, _)/' pattern.frob > cured.frob
  $ frobc check cured.frob
