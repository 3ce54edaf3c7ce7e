Where the output and the equations of a `proc` are written. Every replacement that a message offers
compiles when it is pasted.

Equations before the output:

  $ cat > before.frob <<'FROB'
  > import Robot
  > drive = proc i ->
  >     v = 0.3[1/s] * frontSonar i
  >     roMake (setVelTR v 0)
  > main = reactimateRobot drive
  > FROB
  $ frobc check before.frob
  error[E0110]: expected an operator, an argument, or the end of this definition, found `=`
   --> before.frob:3:7
    |
  3 |     v = 0.3[1/s] * frontSonar i
    |       ^
    |
    = hint: write the output first, and the equations below it in a `where`: `drive = proc i -> roMake (setVelTR v 0) where`, and below it, indented, `v = 0.3[1/s] * frontSonar i`
  
  1 error
  [1]
  $ sed -e '2s:$: roMake (setVelTR v 0) where:' -e 4d before.frob > pasted.frob && frobc check pasted.frob

A second `where`:

  $ cat > second.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR v 0) where
  >     v = if near then 0 else 0.3[m/s]
  >   where
  >     near = frontSonar i < 0.5[m]
  > main = reactimateRobot drive
  > FROB
  $ frobc check second.frob
  error[E0205]: unknown name `i`
   --> second.frob:5:23
    |
  2 | drive = proc i -> roMake (setVelTR v 0) where
    |              - this `i` is a signal of the `proc`
  ...
  5 |     near = frontSonar i < 0.5[m]
    |                       ^
    |
    = hint: this second `where` belongs to the whole definition, so it cannot use signals: move its equations into the first `where`
  
  1 error
  [1]
  $ sed '/^  where/d' second.frob > pasted.frob && frobc check pasted.frob

An equation in the `do` of a `proc`:

  $ cat > in_do.frob <<'FROB'
  > import Robot
  > drive = proc i -> do
  >     d = frontSonar i
  >     returnA -< roMake (setVelTR (0.3[1/s] * d) 0)
  > main = reactimateRobot drive
  > FROB
  $ frobc check in_do.frob
  error[E0110]: expected `<-`, `-<`, or the end of this statement, found `=`
   --> in_do.frob:3:7
    |
  3 |     d = frontSonar i
    |       ^
    |
    = hint: in a `do`, write an equation with `let`: `let d = frontSonar i`
  
  1 error
  [1]
  $ sed 's:    d =:    let d =:' in_do.frob > pasted.frob && frobc check pasted.frob

A function that runs signal functions:

  $ cat > function.frob <<'FROB'
  > import Robot
  > drive :: RobotInput -> RobotOutput
  > drive i = roMake (setVelTR (0.3[1/s] * frontSonar i) 0)
  > main = reactimateRobot drive
  > FROB
  $ frobc check function.frob
  error[E0304]: expected a signal function, found a function: `RobotInput -> RobotOutput`
   --> function.frob:4:24
    |
  4 | main = reactimateRobot drive
    |        --------------- ^^^^^
    |        |
    |        argument 1 of `reactimateRobot` is `SF a b`
    |
    = hint: `drive` runs signal functions, so it must be a signal function itself: write `drive :: SF RobotInput RobotOutput` and `drive = proc i -> …`
  
  1 error
  [1]
  $ sed -e 's:RobotInput -> RobotOutput:SF RobotInput RobotOutput:' -e 's:drive i =:drive = proc i ->:' function.frob > pasted.frob && frobc check pasted.frob

An output that is not made, in another definition:

  $ cat > not_made.frob <<'FROB'
  > import Robot
  > drive = proc _ -> setVelTR 0.3[m/s] 0
  > main = reactimateRobot drive
  > FROB
  $ frobc check not_made.frob
  error[E0411]: `main` cannot run: its output is a function, `b -> b`, not a robot's output
   --> not_made.frob:2:19
    |
  2 | drive = proc _ -> setVelTR 0.3[m/s] 0
    |                   ^^^^^^^^^^^^^^^^^^^
    |
    = hint: use `roMake` to turn this function into a robot's output, as in `roMake (setVelTR v omega)`
  
  1 error
  [1]
  $ sed 's:setVelTR .*:roMake (&):' not_made.frob > pasted.frob && frobc check pasted.frob

A turn rate that lacks:

  $ cat > turn_rate.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0.3[m/s]))
  > FROB
  $ frobc check turn_rate.frob
  error[E0301]: expected a function that takes one argument, found one that takes 2: `AngularVelocity -> a -> a`
   --> turn_rate.frob:2:43
    |
  2 | main = reactimateRobot (proc _ -> roMake (setVelTR 0.3[m/s]))
    |                                   ------  ^^^^^^^^^^^^^^^^^
    |                                   |
    |                                   argument 1 of `roMake` is `o -> o`
    |
    = hint: `setVelTR` lacks its second argument, `AngularVelocity` (1/s): write `setVelTR 0.3[m/s] 0`, for example
  
  1 error
  [1]
  $ sed 's:setVelTR 0.3.m/s.:& 0:' turn_rate.frob > pasted.frob && frobc check pasted.frob

A `switch` inside a `proc`:

  $ cat > inside.frob <<'FROB'
  > import Robot
  > stop = proc _ -> roMake (setVelTR 0 0)
  > drive = proc i -> switch (roMake (setVelTR 0.3[m/s] 0), edge (bumped i)) (\_ -> stop)
  > main = reactimateRobot drive
  > FROB
  $ frobc check inside.frob
  error[E0301]: expected `SF a (b, Event c)`, found `(d, Event ())`
   --> inside.frob:3:26
    |
  3 | drive = proc i -> switch (roMake (setVelTR 0.3[m/s] 0), edge (bumped i)) (\_ -> stop)
    |                   ------ ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |                   |
    |                   argument 1 of `switch` is `SF a (b, Event c)`
    |
    = hint: `switch` needs a signal function that returns the pair: write `switch (proc i -> (roMake (setVelTR 0.3[m/s] 0), edge (bumped i))) (\_ -> stop) i`
  
  1 error
  [1]
  $ sed 's:switch .*:switch (proc i -> (roMake (setVelTR 0.3[m/s] 0), edge (bumped i))) (\\_ -> stop) i:' inside.frob > pasted.frob && frobc check pasted.frob
  warning[W0201]: `i` hides a local variable of the same name
   --> pasted.frob:3:32
    |
  3 | drive = proc i -> switch (proc i -> (roMake (setVelTR 0.3[m/s] 0), edge (bumped i))) (\_ -> stop) i
    |              -                 ^
    |              |
    |              this variable is hidden
  
  1 warning

An integral or a derivative too many:

  $ cat > integral.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR (integral v) 0) where
  >     v = 0.3[1/s] * frontSonar i)
  > FROB
  $ frobc check integral.frob
  error[E0320]: expected the unit `m/s`, found `m`
   --> integral.frob:2:53
    |
  2 | main = reactimateRobot (proc i -> roMake (setVelTR (integral v) 0) where
    |                                           --------  ^^^^^^^^^^ this is `Float[m]`
    |                                           |
    |                                           argument 1 of `setVelTR` is `Velocity` (m/s)
    |
    = hint: remove `integral`: `v` is already in `m/s`
  
  1 error
  [1]
  $ sed 's:(integral v):v:' integral.frob > pasted.frob && frobc check pasted.frob

Metres per second as `ms^-1`:

  $ cat > per_second.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0.3[ms^-1] 0))
  > FROB
  $ frobc check per_second.frob
  error[E0320]: expected the unit `m/s`, found `1/s`
   --> per_second.frob:2:52
    |
  2 | main = reactimateRobot (proc _ -> roMake (setVelTR 0.3[ms^-1] 0))
    |                                           -------- ^^^^^^^^^^ this is `Float[1/s]`
    |                                           |
    |                                           argument 1 of `setVelTR` is `Velocity` (m/s)
    |
    = hint: write `0.3[m/s]` if you meant that unit
  
  1 error
  [1]
  $ sed 's:ms^-1:m/s:' per_second.frob > pasted.frob && frobc check pasted.frob

A condition in place of an event with a number:

  $ cat > held.frob <<'FROB'
  > import Robot
  > drive = proc i -> roMake (setVelTR v 0) where
  >     v = hold 0.3[m/s] (bumped i)
  > main = reactimateRobot drive
  > FROB
  $ frobc check held.frob
  error[E0301]: expected `Event Float[m/s]`, found `Bool`
   --> held.frob:3:24
    |
  3 |     v = hold 0.3[m/s] (bumped i)
    |         ---- --------  ^^^^^^^^
    |         |    |
    |         |    because this is `Float[m/s]`
    |         argument 2 of `hold` is `Event Float[m/s]`
    |
    = hint: use `tag (edge (bumped i)) x`, which occurs with the value of `x` when the condition becomes True
  
  1 error
  [1]
  $ sed 's:(bumped i):(tag (edge (bumped i)) 0):' held.frob > pasted.frob && frobc check pasted.frob

The event of a mode, which needs `()`:

  $ cat > after.frob <<'FROB'
  > import Robot
  > back = proc _ -> (roMake (setVelTR (-0.1[m/s]) 0), after 1[s])
  > drive = switch back (\_ -> proc _ -> roMake (setVelTR 0 0))
  > main = reactimateRobot drive
  > FROB
  $ frobc check after.frob
  error[E0301]: expected `SF a (b, Event c)`, found `SF a (b, SF d (Event ()))`
   --> after.frob:3:16
    |
  3 | drive = switch back (\_ -> proc _ -> roMake (setVelTR 0 0))
    |         ------ ^^^^
    |         |
    |         argument 1 of `switch` is `SF a (b, Event c)`
    |
    = hint: run the event's signal function on `()`: `after 1[s] ()`
  
  1 error
  [1]
  $ sed 's:after 1.s.:& ():' after.frob > pasted.frob && frobc check pasted.frob

A mode that continues as itself:

  $ cat > itself.frob <<'FROB'
  > import Robot
  > go = proc i -> (roMake (setVelTR 0.3[m/s] 0), edge (bumped i))
  > drive = switch go drive
  > main = reactimateRobot drive
  > FROB
  $ frobc check itself.frob
  error[E0304]: expected a function, found a signal function: `SF a b`
   --> itself.frob:3:9
    |
  3 | drive = switch go drive
    | -----   ^^^^^^^^^^^^^^^
    | |
    | elsewhere `drive` is used as `() -> SF a b`
    |
    = hint: the second argument of `switch` is a function of the event's value: use `switch go (\_ -> drive)`
  
  error[E0304]: expected a signal function, found a function: `() -> SF c d`
   --> itself.frob:4:24
    |
  4 | main = reactimateRobot drive
    |        --------------- ^^^^^
    |        |
    |        argument 1 of `reactimateRobot` is `SF a b`
    |
    = hint: use `arr` to turn a function into a signal function: `arr drive`
  
  2 errors
  [1]
  $ sed 's:go drive:go (\\_ -> drive):' itself.frob > pasted.frob && frobc check pasted.frob
