Values that are known when a signal function starts, and values that are not.

A changing distance instead of a stored one:

  $ cat > distance.frob <<'FROB'
  > import Robot
  > import WallFollow
  > 
  > main = reactimateRobot (proc i -> wallFollow1 (frontSonar i) i)
  > FROB
  $ frobc check distance.frob
  error[E0340]: the arguments of `wallFollow1` before its signal must be static, but `frontSonar` runs here
   --> distance.frob:4:48
    |
  4 | main = reactimateRobot (proc i -> wallFollow1 (frontSonar i) i)
    |                                                ^^^^^^^^^^^^
    |
    = hint: a static value must be known when the signal function starts: run one signal function for each of a few constant settings and choose between their outputs, pass the signal in the input, or use `initially` to keep its first value
  
  1 error
  [1]
  $ sed 's/(frontSonar i) i/0.3[m] i/' distance.frob > cured.frob
  $ frobc check cured.frob

A mode that mentions a signal of the `proc` around it:

  $ cat > mode.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (mode i) 0) where
  >     d = frontSonar i
  >     mode = switch (proc j -> (0.3[m/s], edge (bumped j))) (\_ -> proc _ -> 0.1[1/s] * d))
  > FROB
  $ frobc check mode.frob
  error[E0344]: `mode` is a signal function and must be static, but `d` is a signal
   --> mode.frob:5:87
    |
  4 |     d = frontSonar i
    |         ------------ `d` is a signal: a signal function runs here
  5 |     mode = switch (proc j -> (0.3[m/s], edge (bumped j))) (\_ -> proc _ -> 0.1[1/s] * d))
    |                                                                                       ^
    |
    = hint: pass signals in its input: `mode` can take a pair, as in `proc (x, y) -> …`; to pass a value from one mode to the next, use the event of the switch
  
  1 error
  [1]
  $ sed 's/mode i/mode (i, d)/;s/proc j/proc (j, _)/;s/proc _ -> 0.1/proc (_, e) -> 0.1/;s/[*] d))/* e))/' mode.frob > cured.frob
  $ frobc check cured.frob

A missing threshold:

  $ cat > hysteresis.frob <<'FROB'
  > import Control
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     far = hysteresis 0.5[m] (frontSonar i)
  >     v = if far then 0.3[m/s] else 0)
  > FROB
  $ frobc check hysteresis.frob
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> hysteresis.frob:6:12
    |
  5 |     far = hysteresis 0.5[m] (frontSonar i)
    |           -------------------------------- this defines `far`
  6 |     v = if far then 0.3[m/s] else 0)
    |            ^^^ this is `SF Float[m] Bool`
    |
    = note: expected `Bool`
    = hint: `hysteresis` takes two arguments before its signal: write `hysteresis 0.5[m] … (frontSonar i)`, where the signal is `frontSonar i`
  
  1 error
  [1]
  $ sed 's/0.5.m./& 1[m]/' hysteresis.frob > cured.frob
  $ frobc check cured.frob
