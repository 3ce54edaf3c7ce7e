Where signal functions run in branches, guards and functions.

A robot's sensors and stateless code are allowed there: they run at every instant.

  $ cat > senses.frob <<'FROB'
  > import Robot
  > 
  > blocked :: HasSonar i => SF i Bool
  > blocked = proc i -> frontSonar i < 0.3[m]
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (v i) w) where
  >     v j = if bumped j then 0 else 0.5[1/s] * frontSonar i
  >     w | blocked i = 1[rad/s]
  >       | otherwise = case keyPressed i of
  >           Event k -> if k > 0 then 1[rad/s] else 0
  >           NoEvent -> if frontSonar i > 1[m] then 0 else kTurn * (sideSonar i - 0.5[m])
  >     kTurn = 1[1/(m s)])
  > FROB
  $ frobc check senses.frob

For stateful code, the program must state which of two meanings it has.

  $ cat > remembers.frob <<'FROB'
  > main :: SF (Bool, Velocity, Velocity) (Distance, Float, Float, Float)
  > main = proc (b, v, w) -> (x, y, z, f 1) where
  >     x = if b && v > w then integral v else integral $ v + w
  >     y = if b then 0 else if v > w then after' () else 1
  >     z | edge b == Event () = 1
  >       | otherwise = 0
  >     after' = proc () -> if after 2[s] () == Event () then 1 else 0
  >     f k = k * delay 0 (v / 1[m/s])
  > FROB
  $ frobc check remembers.frob
  error[E0342]: `integral` is run in a branch
   --> remembers.frob:3:28
    |
  3 |     x = if b && v > w then integral v else integral $ v + w
    |                            ^^^^^^^^^^ its output depends on when it started
    |
    = hint: to run it at every instant, add the equation `integralNow = integral v`, and write `integralNow` here
    = hint: to restart it whenever this branch is chosen, write `integralNow = resetOn integral (v, edge (b && v > w))`
    = hint: to pause it while this branch is not chosen, write `integral (if b && v > w then v else 0)` in place of the whole `if`
  
  error[E0342]: `integral` is run in a branch
   --> remembers.frob:3:44
    |
  3 |     x = if b && v > w then integral v else integral $ v + w
    |                                            ^^^^^^^^^^^^^^^^ its output depends on when it started
    |
    = hint: to run it at every instant, add the equation `integralNow = integral $ v + w`, and write `integralNow` here
    = hint: to restart it whenever this branch is chosen, write `integralNow = resetOn integral (v + w, edge (not (b && v > w)))`
    = hint: to pause it while this branch is not chosen, write `integral (if b && v > w then 0 else v + w)` in place of the whole `if`
  
  error[E0342]: `after'` is run in a branch
   --> remembers.frob:4:40
    |
  4 |     y = if b then 0 else if v > w then after' () else 1
    |                                        ^^^^^^^^^ its output depends on when it started
    |
    = hint: to run it at every instant, add the equation `after'Now = after' ()`, and write `after'Now` here
    = hint: to restart it whenever this alternative is chosen, use `switch` to change between signal functions
  
  error[E0342]: `edge` is run in a guard
   --> remembers.frob:5:9
    |
  5 |     z | edge b == Event () = 1
    |         ^^^^^^ its output depends on when it started
    |
    = hint: to run it at every instant, add the equation `edgeNow = edge b`, and write `edgeNow` here
    = hint: to restart it whenever this alternative is chosen, use `switch` to change between signal functions
  
  error[E0343]: `delay` is run in the function `f`
   --> remembers.frob:8:15
    |
  8 |     f k = k * delay 0 (v / 1[m/s])
    |               ^^^^^^^^^^^^^^^^^^^^ a function cannot run a signal function, because a signal function has state: run it in a `proc`
    |
    = hint: to run it at every instant, add the equation `delayNow = delay 0 (v / 1[m/s])`, and write `delayNow` here
  
  5 errors
  [1]

A value that exists only there cannot be the input of an instance that runs at
every instant.

  $ cat > only_there.frob <<'FROB'
  > main :: SF (Event Velocity, Array 4 Distance) (Distance, Array 4 Velocity, Velocity)
  > main = proc (e, ds) -> (x, map (\d -> derivative d) ds, slope (ds ! 0)) where
  >     x = case e of
  >         Event v -> integral v
  >         NoEvent -> 0
  >     slope d = derivative d
  > FROB
  $ frobc check only_there.frob
  error[E0343]: `derivative` is run in a function
   --> only_there.frob:2:39
    |
  2 | main = proc (e, ds) -> (x, map (\d -> derivative d) ds, slope (ds ! 0)) where
    |                                  -    ^^^^^^^^^^^^ `d` has a value only here
    |                                  |
    |                                  `d` is bound here
    |
    = hint: use `mapSF derivative` to run one instance for each element of an array
  
  error[E0342]: `integral` is run in a branch
   --> only_there.frob:4:20
    |
  4 |         Event v -> integral v
    |               -    ^^^^^^^^^^ `v` has a value only here
    |               |
    |               `v` is bound here
    |
    = hint: a signal function runs at every instant: use an input that always has a value, or run it on events with `onEvent`
  
  error[E0343]: `derivative` is run in the function `slope`
   --> only_there.frob:6:15
    |
  6 |     slope d = derivative d
    |           -   ^^^^^^^^^^^^ `d` has a value only here
    |           |
    |           `d` is bound here
    |
    = hint: turn `slope` into a signal function, `proc d -> …`
  
  3 errors
  [1]
