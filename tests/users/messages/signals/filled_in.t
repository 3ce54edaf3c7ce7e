Hints that are filled in with the names of the program. The test pastes each fix.

A setting that changes: one instance runs for each value.

  $ cat > setting.frob <<'FROB'
  > import Control
  > main :: SF (Float, Bool) Float
  > main = proc (x, noisy) -> lowPass tau x where
  >     tau = if noisy then 1[s] else 0.1[s]
  > FROB
  $ frobc check setting.frob 2>&1 | grep -e ^error -e hint
  error[E0340]: the arguments of `lowPass` before its signal must be static, but `tau` is a signal
    = hint: run one instance for each setting, and choose between their outputs: add the equations `one = lowPass 1[s] x` and `two = lowPass 0.1[s] x`, and write `if noisy then one else two` here
  $ cat > pasted.frob <<'FROB'
  > import Control
  > main :: SF (Float, Bool) Float
  > main = proc (x, noisy) -> if noisy then one else two where
  >     one = lowPass 1[s] x
  >     two = lowPass 0.1[s] x
  > FROB
  $ frobc check pasted.frob
  $ for e in 'rateLimit r x' 'delayBy t x' 'lowPass (if fast then 0.1[s] else 1[s]) x' 'pid g x' 'lowPass (x * 1[s]) x'; do
  >   printf '%s\n' 'import Control' 'main :: SF (Float, Bool) Float' 'main = proc (x, fast) -> y where' "    y = $e" \
  >     '    r = if fast then 1[1/s] else 2[1/s]' \
  >     '    t = if fast then 0.1[s] else if x > 1 then 0.2[s] else 2[s]' \
  >     '    g = if fast then low else low { kp = 2 }' \
  >     'low :: Pid[1, 1]' 'low = Pid { kp = 1, ki = 0, kd = 0, largest = 1 }' > settings.frob
  >   frobc check settings.frob 2>&1 | grep hint
  > done
    = hint: run one instance for each setting, and choose between their outputs: add the equations `one = rateLimit 1[1/s] x` and `two = rateLimit 2[1/s] x`, and write `if fast then one else two` here
    = hint: run one instance for each setting, and choose between their outputs: add the equations `one = delayBy 0.1[s] x`, `two = delayBy 0.2[s] x` and `three = delayBy 2[s] x`, and write `if fast then one else if x > 1 then two else three` here
    = hint: run one instance for each setting, and choose between their outputs: add the equations `one = lowPass 0.1[s] x` and `two = lowPass 1[s] x`, and write `if fast then one else two` here
    = hint: run one instance for each setting, and choose between their outputs: add the equations `one = pid low x` and `two = pid (low { kp = 2 }) x`, and write `if fast then one else two` here
    = hint: a static value must be known when the signal function starts: run one signal function for each of a few constant settings and choose between their outputs, pass the signal in the input, or use `initially` to keep its first value
  $ cat > pasted.frob <<'FROB'
  > import Control
  > main :: SF (Float, Bool) Float
  > main = proc (x, fast) -> if fast then one else if x > 1 then two else three where
  >     one   = delayBy 0.1[s] x
  >     two   = delayBy 0.2[s] x
  >     three = delayBy 2[s] x
  > FROB
  $ frobc check pasted.frob

A value that keeps or counts:

  $ for e in 'n = if bumped then n + 1 else n' 'n = n + 1' 'n = if bumped then 1 else n - k
  >     k = if n > 3 then 1 else 0'; do
  >   printf 'main :: SF Bool Int\nmain = proc bumped -> n where\n    %s\n' "$e" > counter.frob
  >   frobc check counter.frob 2>&1 | grep 'hint: let'
  > done
    = hint: let `n` read its own previous value: write `before = delay 0 n` and `n = if bumped then before + 1 else before`, where 0 is the initial value
    = hint: let `n` read its own previous value: write `n = delay 0 n + 1`, where 0 is the initial value
    = hint: let `n` read its own previous value: write `before = delay 0 n` and `n = if bumped then 1 else before - k`, where 0 is the initial value
  $ printf 'main :: SF Bool Int\nmain = proc bumped -> n where\n    before = delay 0 n\n    n = if bumped then before + 1 else before\n' > pasted.frob
  $ frobc check pasted.frob
  $ printf 'main :: SF (Bool, Bool) Bool\nmain = proc (on, off) -> stopped where\n    stopped = if on then True else if off then False else stopped\n' > latch.frob
  $ frobc check latch.frob 2>&1 | grep hint
    = hint: let `stopped` read its own previous value: write `before = delay False stopped` and `stopped = if on then True else if off then False else before`, where False is the initial value
  $ printf 'main :: SF (Bool, Bool) Bool\nmain = proc (on, off) -> stopped where\n    before = delay False stopped\n    stopped = if on then True else if off then False else before\n' > pasted.frob
  $ frobc check pasted.frob
  $ printf 'data Side = Port | Starboard\nmain :: SF Bool Side\nmain = proc on -> side where\n    side = if on then Starboard else side\n' > side.frob
  $ frobc check side.frob 2>&1 | grep hint
    = hint: let `side` read its own previous value: write `before = delay Port side` and `side = if on then Starboard else before`, where Port is the initial value
  $ printf 'data Side = Port | Starboard\nmain :: SF Bool Side\nmain = proc on -> side where\n    before = delay Port side\n    side = if on then Starboard else before\n' > pasted.frob
  $ frobc check pasted.frob

A function that runs a signal function:

  $ cat > function.frob <<'FROB'
  > import Robot
  > tooNear :: RobotInput -> Bool
  > tooNear i = frontSonar i < 0.4[m]
  > main :: SF RobotInput Bool
  > main = proc i -> tooNear i
  > FROB
  $ frobc check function.frob 2>&1 | grep hint
    = hint: run it in a `proc`: write `tooNear :: SF RobotInput Bool`, and below it `tooNear = proc i -> frontSonar i < 0.4[m]`
  $ sed '2s/.*/tooNear :: SF RobotInput Bool/; 3s/.*/tooNear = proc i -> frontSonar i < 0.4[m]/' function.frob > pasted.frob && frobc check pasted.frob
  $ cat > two.frob <<'FROB'
  > import Robot
  > nearer :: HasSonar i => Distance -> i -> Bool
  > nearer d i = frontSonar i < d
  > main :: SF RobotInput Bool
  > main = proc i -> nearer 0.4[m] i
  > FROB
  $ frobc check two.frob 2>&1 | grep hint
    = hint: run it in a `proc`: write `nearer :: HasSonar i => Distance -> SF i Bool`, and below it `nearer d = proc i -> frontSonar i < d`
  $ sed '2s/.*/nearer :: HasSonar i => Distance -> SF i Bool/; 3s/.*/nearer d = proc i -> frontSonar i < d/' two.frob > pasted.frob && frobc check pasted.frob
  $ cat > parameter.frob <<'FROB'
  > import Robot
  > nearer :: Distance -> SF RobotInput Bool
  > nearer d i = frontSonar i < d
  > main :: SF RobotInput Bool
  > main = nearer 0.4[m]
  > FROB
  $ frobc check parameter.frob 2>&1 | grep hint
    = hint: take the signal in a `proc`: begin the definition with `nearer d = proc i ->`
  $ sed '3s/nearer d i =/nearer d = proc i ->/' parameter.frob > pasted.frob && frobc check pasted.frob

A signal of another `proc`:

  $ cat > other.frob <<'FROB'
  > import Robot
  > sense :: SF RobotInput Bool
  > sense = proc i -> ahead < 0.5[m] where
  >     ahead = frontSonar i
  > main :: SF RobotInput RobotOutput
  > main = proc i -> roMake (setVelTR (0.3[1/s] * ahead) 0)
  > FROB
  $ frobc check other.frob 2>&1 | grep hint
    = hint: a signal can only be used inside its `proc`: add a `where` to the `proc` in `main`, and write `ahead = frontSonar i` below it, or make the value part of this `proc`'s input
  $ sed '6s/$/ where\n    ahead = frontSonar i/' other.frob > pasted.frob && frobc check pasted.frob

The first part of `switch` without an event, and `hold` without one:

  $ cat > mode.frob <<'FROB'
  > import Robot
  > ahead, away :: SF RobotInput RobotOutput
  > ahead = switch (proc _ -> roMake (setVelTR 0.3[m/s] 0)) (\_ -> away)
  > away  = proc _ -> roMake (setVelTR 0 0.5[rad/s])
  > main = reactimateRobot ahead
  > FROB
  $ frobc check mode.frob
  error[E0360]: a pair of an output and an event is needed here, but `roMake` returns only an output
   --> mode.frob:3:27
    |
  3 | ahead = switch (proc _ -> roMake (setVelTR 0.3[m/s] 0)) (\_ -> away)
    |                           ^^^^^^
    |
    = hint: return a pair of the output and an event: `(roMake (setVelTR 0.3[m/s] 0), after 1[s] ())` ends the mode after 1 s, and `(…, edge c)` ends it when a condition `c` becomes True
  
  1 error
  [1]
  $ sed '3s/roMake (setVelTR 0.3\[m\/s\] 0)/(&, after 1[s] ())/' mode.frob > pasted.frob && frobc check pasted.frob
  $ cat > hold.frob <<'FROB'
  > import Robot
  > main :: SF RobotInput Distance
  > main = proc i -> hold 0 driven where
  >     driven = integral (velocity i)
  >     e      = edge (bumped i)
  > FROB
  $ frobc check hold.frob 2>&1 | grep hint
    = hint: this has a value at every instant: to keep its value from the latest occurrence of an event `e`, write `hold 0 (tag e driven)`; otherwise, remove the `hold`
  $ sed '3s/hold 0 driven/hold 0 (tag e driven)/' hold.frob > pasted.frob && frobc check pasted.frob

An index that changes, a field by its first letters, and modules that are built in:

  $ printf 'xs :: Array 3 Float\nxs = [1, 2, 3]\nmain :: SF Int Float\nmain = proc k -> xs ! (k + 1)\n' > index.frob
  $ frobc check index.frob 2>&1 | grep hint
    = hint: use `at (k + 1) 0 xs`, which takes any index and returns `0` if there is no such element
  $ sed 's/xs ! (k + 1)/at (k + 1) 0 xs/' index.frob > pasted.frob && frobc check pasted.frob
  $ printf 'import Geometry\nmain :: SF Pose Distance\nmain = proc p -> p.pos.x\n' > field.frob
  $ frobc check field.frob 2>&1 | grep hint
    = hint: did you mean `position`?
  $ sed 's/p.pos/p.position/' field.frob > pasted.frob && frobc check pasted.frob
  $ for m in Math Time List Random; do
  >   printf 'import %s\nmain :: SF Float Float\nmain = proc x -> sin x\n' $m > module.frob
  >   frobc check module.frob 2>&1 | grep hint
  > done
    = hint: remove this line: mathematical functions are built in, as in `sin x` and `sqrt x`
    = hint: remove this line: time is built in; write `time ()` for the time since the start of the program
    = hint: remove this line: arrays are built in, as in `map f xs` and `foldl (+) 0 xs`
    = hint: write `import Sources` instead; `whiteNoise 1 ()` returns random numbers, with 1 as the seed
  $ sed 1d module.frob > pasted.frob && frobc check pasted.frob
