Inputs of a `proc` where it has ended, or has no name for them. Every replacement that a message offers
compiles when it is pasted.

The event as a separate argument of `switch`:

  $ cat > separate.frob <<'FROB'
  > import Robot
  > ahead = switch (proc i -> roMake (setVelTR 0.3[m/s] 0)) (edge (bumped i)) (\_ -> halt)
  > halt = proc _ -> roMake (setVelTR 0 0)
  > main = reactimateRobot ahead
  > FROB
  $ frobc check separate.frob
  error[E0205]: unknown name `i`
   --> separate.frob:2:71
    |
  2 | ahead = switch (proc i -> roMake (setVelTR 0.3[m/s] 0)) (edge (bumped i)) (\_ -> halt)
    |                      -                                                ^
    |                      |
    |                      this `i` is a signal of the `proc`
    |
    = hint: `switch` takes the output and the event as a pair in its first argument: write `switch (proc i -> (roMake (setVelTR 0.3[m/s] 0), edge (bumped i))) (\_ -> halt)`
  
  1 error
  [1]
  $ sed 's:proc i -> \(.*\)) (edge (bumped i)):proc i -> (\1, edge (bumped i))):' separate.frob > pasted.frob && frobc check pasted.frob

The input of a mode in the next one:

  $ cat > next.frob <<'FROB'
  > import Robot
  > ahead = switch (proc i -> (roMake (setVelTR 0.3[m/s] 0), edge (bumped i))) (\_ -> turn (bumpedLeft i))
  > turn left = proc _ -> roMake (setVelTR 0 (if left then -0.5[rad/s] else 0.5[rad/s]))
  > main = reactimateRobot ahead
  > FROB
  $ frobc check next.frob
  error[E0205]: unknown name `i`
   --> next.frob:2:100
    |
  2 | ahead = switch (proc i -> (roMake (setVelTR 0.3[m/s] 0), edge (bumped i))) (\_ -> turn (bumpedLeft i))
    |                      -                                                                             ^
    |                      |
    |                      this `i` is a signal of the `proc`
    |
    = hint: carry the value in the event: write `tag (edge (bumped i)) (bumpedLeft i)` in place of `edge (bumped i)`, and `\x -> turn x` here
  
  1 error
  [1]
  $ sed -e 's:edge (bumped i):tag (edge (bumped i)) (bumpedLeft i):' -e 's:.._ -> turn (bumpedLeft i):(\\x -> turn x:' next.frob > pasted.frob && frobc check pasted.frob

An input without a name:

  $ cat > unnamed.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc _ -> roMake (setVelTR v 0) where
  >     v = if frontSonar i < 0.5[m] then 0 else 0.3[m/s])
  > FROB
  $ frobc check unnamed.frob
  error[E0205]: unknown name `i`
   --> unnamed.frob:3:23
    |
  3 |     v = if frontSonar i < 0.5[m] then 0 else 0.3[m/s])
    |                       ^
    |
    = hint: give the input of this `proc` a name: `proc i -> …`
  
  1 error
  [1]
  $ sed 's:proc _:proc i:' unnamed.frob > pasted.frob && frobc check pasted.frob

  $ cat > not_applied.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc _ -> roMake (setVelTR v 0) where
  >     v = if frontSonar < 0.5[m] then 0 else 0.3[m/s])
  > FROB
  $ frobc check not_applied.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> not_applied.frob:3:12
    |
  3 |     v = if frontSonar < 0.5[m] then 0 else 0.3[m/s])
    |            ^^^^^^^^^^   ------ this is `Float[m]`
    |            |
    |            this is `SF a Distance`
    |
    = hint: give the input of the `proc` a name, `proc i -> …`, and write `frontSonar i` here
  
  1 error
  [1]
  $ sed -e 's:proc _:proc i:' -e 's:frontSonar:frontSonar i:' not_applied.frob > pasted.frob && frobc check pasted.frob

A signal function that an equation names:

  $ cat > named.frob <<'FROB'
  > f :: SF () Bool
  > f = proc _ -> t > 5[s] where
  >     t = time
  > FROB
  $ frobc check named.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> named.frob:2:15
    |
  2 | f = proc _ -> t > 5[s] where
    |               ^   ---- this is a number in `s`
    |               |
    |               this is `SF a Time`
  3 |     t = time
    |         ---- this defines `t`
    |
    = hint: run the signal function on `()` in its definition: `t = time ()`
  
  1 error
  [1]
  $ sed 's:t = time:t = time ():' named.frob > pasted.frob && frobc check pasted.frob

  $ cat > held.frob <<'FROB'
  > f :: SF (Event Distance) Distance
  > f = proc echo -> d where
  >     d = hold echo
  > FROB
  $ frobc check held.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> held.frob:2:18
    |
  1 | f :: SF (Event Distance) Distance
    |      ---------------------------- the signature of `f` requires the output `Distance` (m)
  2 | f = proc echo -> d where
    |                  ^ this is `SF (Event (Event Distance)) (Event Distance)`
  3 |     d = hold echo
    |         --------- this defines `d`
    |
    = note: expected `Distance` (m)
    = hint: `hold` takes an initial value before its signal: write `hold 0 echo`
  
  1 error
  [1]
  $ sed 's:hold echo:hold 0 echo:' held.frob > pasted.frob && frobc check pasted.frob

A signal function in a test:

  $ cat > tested.frob <<'FROB'
  > import Trial
  > ramp :: SF Float Float
  > ramp = proc x -> delay 0 x
  > test "starts at 0" = ramp 0 == 0
  > FROB
  $ frobc check tested.frob
  error[E0341]: `ramp` is run outside of a `proc`
   --> tested.frob:4:22
    |
  4 | test "starts at 0" = ramp 0 == 0
    |                      ^^^^^^ only a `proc` can run a signal function
    |
    = hint: in the test, run it for some time: `during 1[s] (proc () -> ramp 0 == 0)`
  
  1 error
  [1]
  $ sed 's:= ramp 0 == 0:= during 1[s] (proc () -> ramp 0 == 0):' tested.frob > pasted.frob && frobc check pasted.frob
