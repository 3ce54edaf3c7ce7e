Events, Bools, Maybes, and values: each used instead of another.

Events from two Bools:

  $ cat > either.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     hit = mergeE (bumpedLeft i) (bumpedRight i)
  >     v = hold 0.3[m/s] (tag hit 0))
  > FROB
  $ frobc check either.frob
  error[E0301]: expected `Event a`, found `Bool`
   --> either.frob:4:19
    |
  4 |     hit = mergeE (bumpedLeft i) (bumpedRight i)
    |           ------  ^^^^^^^^^^^^
    |           |
    |           argument 1 of `mergeE` is `Event a`
    |
    = hint: to combine two conditions, write `a || b`; for an event, write `edge (bumpedLeft i)`, which occurs when the condition becomes True, or `when (bumpedLeft i)`, which occurs whenever it is True
  
  1 error
  [1]
  $ sed 's,mergeE (bumpedLeft i) (bumpedRight i),edge (bumpedLeft i || bumpedRight i),' either.frob > cured.frob
  $ frobc check cured.frob

An event is not a `Maybe`:

  $ cat > maybe.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = case keyPressed i of
  >         Just k -> 0.1[m/s]
  >         Nothing -> 0)
  > FROB
  $ frobc check maybe.frob
  error[E0301]: this pattern matches `Maybe a`, but the value is `Event Int`
   --> maybe.frob:5:9
    |
  4 |     v = case keyPressed i of
    |              ------------ the value is `Event Int`
  5 |         Just k -> 0.1[m/s]
    |         ^^^^^^
    |
    = hint: match an event with the patterns `Event x` and `NoEvent`
  
  1 error
  [1]
  $ sed 's/Just k/Event _/;s/Nothing/NoEvent/' maybe.frob > cured.frob
  $ frobc check cured.frob

A value in an event, or in a `Maybe`, is compared as one:

  $ cat > compared.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = if keyPressed i == 119 then 0.3[m/s] else 0)
  > FROB
  $ frobc check compared.frob
  error[E0301]: expected `Event Int`, found a number
   --> compared.frob:4:28
    |
  4 |     v = if keyPressed i == 119 then 0.3[m/s] else 0)
    |            ------------    ^^^
    |            |
    |            this is `Event Int`
    |
    = hint: compare the values like this: `keyPressed i == Event 119`
  
  1 error
  [1]
  $ sed 's/== 119/== Event 119/' compared.frob > cured.frob
  $ frobc check cured.frob

  $ cat > beacon.frob <<'FROB'
  > import Robot
  > 
  > main :: (HasBeacon i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (if beaconSeen i == 244 then 0 else 0.2[m/s]) 0))
  > FROB
  $ frobc check beacon.frob
  error[E0301]: expected `Maybe Int`, found a number
   --> beacon.frob:4:72
    |
  4 | main = reactimateRobot (proc i -> roMake (setVelTR (if beaconSeen i == 244 then 0 else 0.2[m/s]) 0))
    |                                                        ------------    ^^^
    |                                                        |
    |                                                        this is `Maybe Int`
    |
    = hint: compare the values like this: `beaconSeen i == Just 244`
  
  1 error
  [1]
  $ sed 's/== 244/== Just 244/' beacon.frob > cured.frob
  $ frobc check cured.frob

Each event of `accum` carries a function:

  $ cat > accum.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     n = accumHold 0 (edge (bumped i))
  >     v = if n > 3 then 0 else 0.3[m/s])
  > FROB
  $ frobc check accum.frob
  error[E0301]: expected `Event (n[u] -> n[u])`, found `Event ()`
   --> accum.frob:4:22
    |
  4 |     n = accumHold 0 (edge (bumped i))
    |         --------- -  ^^^^^^^^^^^^^^^
    |         |         |
    |         |         because this is a number
    |         argument 2 of `accumHold` is `Event (n[u] -> n[u])`
    |
    = hint: each event must carry a function of the previous value, as in `tag (edge (bumped i)) (\n -> n + 1)`; to count events, use `count`
  
  1 error
  [1]
  $ sed 's/accumHold 0 (\(.*\))$/accumHold 0 (tag (\1) (\\k -> k + 1))/' accum.frob > cured.frob
  $ frobc check cured.frob

  $ cat > initial_last.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     clicks = accumHold (buttonPressed "faster" i) 0
  >     v = 0.1[m/s] * clicks)
  > FROB
  $ frobc check initial_last.frob
  error[E0301]: expected `Event (Event () -> Event ())`, found a number
   --> initial_last.frob:4:51
    |
  4 |     clicks = accumHold (buttonPressed "faster" i) 0
    |              ---------  ------------------------  ^
    |              |          |
    |              |          because this is `Event ()`
    |              argument 2 of `accumHold` is `Event (Event () -> Event ())`
    |
    = hint: after the initial value, write an event that carries a function of the previous value, as in `tag e (\n -> n + 1)`
  
  1 error
  [1]
  $ sed 's/accumHold .*/accumHold 0 (tag (buttonPressed "faster" i) (\\k -> k + 1))/' initial_last.frob > cured.frob
  $ frobc check cured.frob

`hold` takes an event:

  $ cat > held.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (0.5[1/s] * d) 0) where
  >     d = hold 0[m] (frontSonar i))
  > FROB
  $ frobc check held.frob
  error[E0301]: expected `Event n[m]`, found `Distance` (m)
   --> held.frob:4:20
    |
  4 |     d = hold 0[m] (frontSonar i))
    |         ---- ----  ^^^^^^^^^^^^
    |         |    |
    |         |    because this is a number in `m`
    |         argument 2 of `hold` is `Event n[m]`
    |
    = hint: this has a value at every instant: to keep its value from the latest occurrence of an event `e`, write `hold 0[m] (tag e (frontSonar i))`; otherwise, remove the `hold`
  
  1 error
  [1]
  $ sed 's/hold 0.m. (frontSonar i)/frontSonar i/' held.frob > cured.frob
  $ frobc check cured.frob

The events of `edge` have no value:

  $ cat > unit.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (switch first' (\d -> turn d)) where
  >     first' = proc i -> (roMake (setVelTR 0.3[m/s] 0), edge (frontSonar i < 0.5[m]))
  >     turn d = proc _ -> roMake (setVelTR 0 (if d > 0.3[m] then 1[rad/s] else -1[rad/s]))
  > FROB
  $ frobc check unit.frob
  error[E0301]: expected `Float[m]`, found `()`
   --> unit.frob:3:51
    |
  3 | main = reactimateRobot (switch first' (\d -> turn d)) where
    |                                              ---- ^
    |                                              |
    |                                              argument 1 of `turn` is `Float[m]`
    |
    = hint: the events of `edge`, `when` and `after` have the value `()`: write `tag e x` for an event with the value of `x`
  
  1 error
  [1]
  $ sed 's/edge (frontSonar i < 0.5.m.)/tag (edge (frontSonar i < 0.5[m])) (sideSonar i)/' unit.frob > cured.frob
  $ frobc check cured.frob

A value where an event with that value is expected:

  $ cat > tone.frob <<'FROB'
  > import Create
  > import Robot
  > main :: Program CreateInput CreateOutput
  > main = reactimateRobot (proc i -> roMake (playTone 440[Hz]))
  > FROB
  $ frobc check tone.frob
  error[E0301]: expected `Event Tone`, found a number in `1/s`
   --> tone.frob:4:52
    |
  4 | main = reactimateRobot (proc i -> roMake (playTone 440[Hz]))
    |                                           -------- ^^^^^^^
    |                                           |
    |                                           argument 1 of `playTone` is `Event Tone`
    |
    = hint: use `tag e (Tone { pitch = …, lasting = … })`, which occurs with this value when the event `e` occurs, or `NoEvent`, which never occurs
  
  1 error
  [1]
  $ sed 's/440.Hz./(tag (edge (bumped i)) (Tone { pitch = 440[Hz], lasting = 1[s] }))/' tone.frob > cured.frob
  $ frobc check cured.frob
