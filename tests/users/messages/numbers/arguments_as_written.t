Arguments in the syntax of other languages, or almost correct.

A function application as an argument:

  $ cat > edge.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     hit = edge bumped i
  >     v = hold 0.3[m/s] (tag hit 0))
  > FROB
  $ frobc check edge.frob
  error[E0301]: expected `Bool`, found the function `a -> Bool`
   --> edge.frob:4:16
    |
  4 |     hit = edge bumped i
    |           ---- ^^^^^^
    |           |
    |           argument 1 of `edge` is `Bool`
    |
    = hint: put parentheses around the argument: `edge (bumped i)`
  
  1 error
  [1]
  $ sed 's/edge bumped i/edge (bumped i)/' edge.frob > cured.frob
  $ frobc check cured.frob

A point without a digit before it:

  $ cat > point.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc _ -> roMake (setVelTR .5[m/s] 0))
  > FROB
  $ frobc check point.frob
  error[E0105]: the number `.5` has no digit before its decimal point
   --> point.frob:3:52
    |
  3 | main = reactimateRobot (proc _ -> roMake (setVelTR .5[m/s] 0))
    |                                                    ^^
    |
    = hint: write a digit before the decimal point: `0.5`
  
  1 error
  [1]
  $ sed 's/[.]5/0.5/' point.frob > cured.frob
  $ frobc check cured.frob

Two arguments instead of one pair:

  $ cat > pair.frob <<'FROB'
  > import Robot
  > 
  > steer :: SF (Distance, Distance) Velocity
  > steer = proc (f, s) -> 0.5[1/s] * (f - s)
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (steer (frontSonar i) (sideSonar i)) 0))
  > FROB
  $ frobc check pair.frob
  error[E0301]: expected `(Distance, Distance)`, found `Distance` (m)
   --> pair.frob:6:60
    |
  6 | main = reactimateRobot (proc i -> roMake (setVelTR (steer (frontSonar i) (sideSonar i)) 0))
    |                                                     -----  ^^^^^^^^^^^^
    |                                                     |
    |                                                     argument 1 of `steer` is `(Distance, Distance)`
    |
    = hint: `steer` takes one tuple with 2 elements: write `steer (frontSonar i, sideSonar i)`
  
  1 error
  [1]
  $ sed 's/steer (frontSonar i) (sideSonar i)/steer (frontSonar i, sideSonar i)/' pair.frob > cured.frob
  $ frobc check cured.frob

A function instead of a signal function:

  $ cat > lambda.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (\_ -> roMake (setVelTR 0.3[m/s] 0))
  > FROB
  $ frobc check lambda.frob
  error[E0304]: expected a signal function, found a function: `c -> d`
   --> lambda.frob:3:25
    |
  3 | main = reactimateRobot (\_ -> roMake (setVelTR 0.3[m/s] 0))
    |        ---------------  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |        |
    |        argument 1 of `reactimateRobot` is `SF a b`
    |
    = hint: write `proc _ -> …` in place of `\_ -> …`
  
  1 error
  [1]
  $ sed 's/.._ ->/(proc _ ->/' lambda.frob > cured.frob
  $ frobc check cured.frob
