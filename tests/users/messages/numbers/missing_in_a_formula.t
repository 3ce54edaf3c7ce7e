A formula in which a number lacks its unit, and one with an exponent that is not a number.

  $ cat > braking.frob <<'FROB'
  > import Robot
  > 
  > stoppable :: Distance -> Velocity
  > stoppable d = sqrt (2 * 0.3 * d)
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (stoppable (frontSonar i)) 0))
  > FROB
  $ frobc check braking.frob
  error[E0320]: expected the unit `m/s`, found `m^(1/2)`
   --> braking.frob:4:15
    |
  3 | stoppable :: Distance -> Velocity
    |              -------------------- the signature of `stoppable` requires `Velocity` (m/s)
  4 | stoppable d = sqrt (2 * 0.3 * d)
    |               ^^^^^^^^^^^^^^^^^^ this is `Float[m^(1/2)]`
    |
    = hint: perhaps a number lacks its unit: if `0.3` has no unit, the unit of the result is `m^(1/2)`
  
  1 error
  [1]
  $ sed 's/0.3/0.3[m\/s^2]/' braking.frob > cured.frob
  $ frobc check cured.frob

  $ cat > power.frob <<'FROB'
  > import Robot
  > 
  > decay :: Float -> Int -> Float
  > decay x n = x ^ n
  > 
  > main = reactimateRobot (proc _ -> roMake (setVelTR (0.3[m/s] * decay 0.5 2) 0))
  > FROB
  $ frobc check power.frob
  error[E0117]: the exponent of `^` must be a literal whole number
   --> power.frob:4:17
    |
  4 | decay x n = x ^ n
    |                 ^
    |
    = hint: for other exponents, use `**`, which takes Floats without a unit; for an Int `n`, write `x ** toFloat n`
  
  1 error
  [1]
  $ sed 's/x . n/x ** toFloat n/' power.frob > cured.frob
  $ frobc check cured.frob

  $ cat > loop.frob <<'FROB'
  > import Robot
  > main = reactimateTask (do
  >     while True do
  >         forward 1[m])
  > FROB
  $ frobc check loop.frob
  error[E0110]: Frob has no `while`
   --> loop.frob:3:5
    |
  3 |     while True do
    |     ^^^^^
    |
    = hint: to repeat the tasks of this block, write `forever $ do` in place of this line
  
  1 error
  [1]
