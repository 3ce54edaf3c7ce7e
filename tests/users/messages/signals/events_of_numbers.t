Events that are held or summed.

  $ cat > for_a_time.frob <<'FROB'
  > main :: SF Bool Bool
  > main = proc b -> hold 2[s] b
  > FROB
  $ frobc check for_a_time.frob
  error[E0301]: expected `Event n[s]`, found `Bool`
   --> for_a_time.frob:2:28
    |
  2 | main = proc b -> hold 2[s] b
    |                  ---- ---- ^
    |                  |    |
    |                  |    because this is a number in `s`
    |                  argument 2 of `hold` is `Event n[s]`
    |
    = hint: to find out if a condition was True within the last 2 seconds, write `within 2[s] b`, with `import Past`; `hold x0 e` keeps the value of an event
  
  1 error
  [1]

  $ cat > added_up.frob <<'FROB'
  > main :: SF Bool Int
  > main = proc b -> accumHold 0 (tag (edge b) 1)
  > FROB
  $ frobc check added_up.frob
  error[E0301]: expected `Event (n[u] -> n[u])`, found `Event n1[1]`
   --> added_up.frob:2:31
    |
  2 | main = proc b -> accumHold 0 (tag (edge b) 1)
    |                  --------- -  ^^^^^^^^^^^^^^
    |                  |         |
    |                  |         because this is a number
    |                  argument 2 of `accumHold` is `Event (n[u] -> n[u])`
    |
    = hint: each event must carry a function of the previous value: to add up the numbers, write `tag (edge b) (\n -> n + 1)`
  
  1 error
  [1]

A function of the input where a switch expects signal functions:

  $ cat > functions.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> o where
  >     o = switch (drive i) (\_ -> turn i)
  >     drive i = (roMake (setVelTR 0.2[m/s] 0), edge (frontSonar i < 0.5[m]))
  >     turn i = roMake (setVelTR 0 0.5[rad/s]))
  > FROB
  $ frobc check functions.frob
  error[E0301]: expected `SF a (b, Event c)`, found `(d, Event ())`
   --> functions.frob:3:17
    |
  3 |     o = switch (drive i) (\_ -> turn i)
    |         ------  ^^^^^^^
    |         |
    |         argument 1 of `switch` is `SF a (b, Event c)`
    |
    = hint: `switch` needs a signal function: define `drive = proc i -> …`, and write `switch drive … i`
  
  warning[W0201]: `i` hides a local variable of the same name
   --> functions.frob:4:11
    |
  2 | main = reactimateRobot (proc i -> o where
    |                              - this variable is hidden
  3 |     o = switch (drive i) (\_ -> turn i)
  4 |     drive i = (roMake (setVelTR 0.2[m/s] 0), edge (frontSonar i < 0.5[m]))
    |           ^
  
  warning[W0201]: `i` hides a local variable of the same name
   --> functions.frob:5:10
    |
  2 | main = reactimateRobot (proc i -> o where
    |                              - this variable is hidden
  ...
  5 |     turn i = roMake (setVelTR 0 0.5[rad/s]))
    |          ^
  
  1 error, 2 warnings
  [1]
