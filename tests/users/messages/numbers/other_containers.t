A tuple instead of an array, a number instead of a mark, an integral with a
reset.

  $ cat > tuple.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (0.1[1/s] * l) 0) where
  >     [l, _] = map (\d -> d / 2) (sideSonar i, rightSonar i))
  > FROB
  $ frobc check tuple.frob
  error[E0301]: expected `Array m Float[u]`, found a tuple with 2 elements
   --> tuple.frob:4:32
    |
  4 |     [l, _] = map (\d -> d / 2) (sideSonar i, rightSonar i))
    |              ---               ^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |              |
    |              argument 2 of `map` is `Array m Float[u]`
    |
    = hint: write an array in brackets: `[sideSonar i, rightSonar i]`
  
  1 error
  [1]
  $ sed 's/(sideSonar i, rightSonar i)/[sideSonar i, rightSonar i]/' tuple.frob > cured.frob
  $ frobc check cured.frob

  $ cat > mark.frob <<'FROB'
  > import Display
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.1[m/s] 0 . draw (frontSonar i)))
  > FROB
  $ frobc check mark.frob
  error[E0301]: expected `Mark`, found `Distance` (m)
   --> mark.frob:4:71
    |
  4 | main = reactimateRobot (proc i -> roMake (setVelTR 0.1[m/s] 0 . draw (frontSonar i)))
    |                                                                 ----  ^^^^^^^^^^^^
    |                                                                 |
    |                                                                 argument 1 of `draw` is `Mark`
    |
    = hint: to make a mark from a number, write `number "name" (frontSonar i)`
  
  1 error
  [1]
  $ sed 's/(frontSonar i)/(number "ahead" (frontSonar i))/' mark.frob > cured.frob
  $ frobc check cured.frob

  $ cat > reset.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (if way > 1[m] then 0 else 0.2[m/s]) 0) where
  >     way = integral (velocity i) (edge (bumped i)))
  > FROB
  $ frobc check reset.frob
  error[E0302]: `integral` takes 1 argument, but is given 2
   --> reset.frob:4:34
    |
  4 |     way = integral (velocity i) (edge (bumped i)))
    |           --------               ^^^^^^^^^^^^^^^ one too many
    |           |
    |           with one argument, its result is `Float[m]`
    |
    = hint: `integral` starts at 0: for another initial value, write `x0 + integral v`; to restart it when an event occurs, write `resetOn integral (v, e)`
  
  1 error
  [1]
  $ sed 's/integral (velocity i) (edge (bumped i))/resetOn integral (velocity i, edge (bumped i))/' reset.frob > cured.frob
  $ frobc check cured.frob

  $ cat > turn.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] w) where
  >     w = 0.5[1/s] * (30[deg/s] - turnRate i))
  > FROB
  $ frobc check turn.frob
  error[E0320]: expected the unit `1/s`, found `1/s^2`
   --> turn.frob:3:61
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] w) where
    |                                           --------          ^ this is `Float[1/s^2]`
    |                                           |
    |                                           argument 2 of `setVelTR` is `AngularVelocity` (1/s)
    |
    = hint: write `0.5`, without a unit, if it is a plain number
  
  1 error
  [1]
  $ sed 's,0.5.1/s.,0.5,' turn.frob > cured.frob
  $ frobc check cured.frob

  $ cat > field.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (if place.x i > 2[m] then 0 else 0.2[m/s]) 0))
  > FROB
  $ frobc check field.frob
  error[E0310]: `a -> Point2` has no field `x`
   --> field.frob:3:62
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR (if place.x i > 2[m] then 0 else 0.2[m/s]) 0))
    |                                                        ----- ^
    |                                                        |
    |                                                        this is `a -> Point2`
    |
    = hint: `place` is a function: write `(place i).x`
  
  1 error
  [1]
  $ sed 's/place.x i/(place i).x/' field.frob > cured.frob
  $ frobc check cured.frob
