Limits that are upside down or negative are reported where they are constants, also times below zero.
The doc comments of the library state which constants a function accepts.

  $ cat > limits.frob <<'FROB'
  > import Angles
  > import Control
  > import Filters
  > import Logic
  > import Pid
  > 
  > low, high :: Float
  > low = 2
  > high = 1
  > 
  > gains :: Pid[1, 1]
  > gains = Pid { kp = 2, ki = 0, kd = 0, largest = -1 }
  > 
  > settings :: PidSettings[1, 1]
  > settings = (pidSettings gains) { lowest = 1, highest = -1, tf = -0.1[s] }
  > 
  > main :: SF (Float, Bool) (Array 9 Float, Int, Array 3 Bool)
  > main = proc (x, b) ->
  >     ( [ clamp low high x, limit (-1) x, rateLimit (-1[1/s]) x, slew 1[1/s] (-1[1/s^2]) x, notch (-3[Hz]) 1[Hz] x
  >       , highPass (-1[s]) x, lowPassAngle (-1[s]) x, pid2 settings (x, 0), clamp (-1) 1 x ]
  >     , clamp 3 2 7
  >     , [hysteresis 2 1 x, pulse (-1[s]) b, onDelay 0[s] b] )
  > FROB
  $ frobc check limits.frob 2>&1 | grep -A 3 warning
  warning[W0316]: this is below zero: `largest` needs a number of at least 0
    --> limits.frob:12:49
     |
  12 | gains = Pid { kp = 2, ki = 0, kd = 0, largest = -1 }
  --
  warning[W0316]: the lower limit of `PidSettings` is above the upper one
    --> limits.frob:15:43
     |
  15 | settings = (pidSettings gains) { lowest = 1, highest = -1, tf = -0.1[s] }
  --
  warning[W0309]: `tf` has a negative time, which counts as zero
    --> limits.frob:15:65
     |
  15 | settings = (pidSettings gains) { lowest = 1, highest = -1, tf = -0.1[s] }
  --
  warning[W0316]: the lower limit of `clamp` is above the upper one
    --> limits.frob:19:15
     |
  19 |     ( [ clamp low high x, limit (-1) x, rateLimit (-1[1/s]) x, slew 1[1/s] (-1[1/s^2]) x, notch (-3[Hz]) 1[Hz] x
  --
  warning[W0316]: this is below zero: `limit` needs a number of at least 0
    --> limits.frob:19:34
     |
  19 |     ( [ clamp low high x, limit (-1) x, rateLimit (-1[1/s]) x, slew 1[1/s] (-1[1/s^2]) x, notch (-3[Hz]) 1[Hz] x
  --
  warning[W0316]: this is below zero: `rateLimit` needs a number of at least 0
    --> limits.frob:19:52
     |
  19 |     ( [ clamp low high x, limit (-1) x, rateLimit (-1[1/s]) x, slew 1[1/s] (-1[1/s^2]) x, notch (-3[Hz]) 1[Hz] x
  --
  warning[W0316]: this is below zero: `slew` needs a number of at least 0
    --> limits.frob:19:77
     |
  19 |     ( [ clamp low high x, limit (-1) x, rateLimit (-1[1/s]) x, slew 1[1/s] (-1[1/s^2]) x, notch (-3[Hz]) 1[Hz] x
  --
  warning[W0316]: this is below zero: `notch` needs a number of at least 0
    --> limits.frob:19:98
     |
  19 |     ( [ clamp low high x, limit (-1) x, rateLimit (-1[1/s]) x, slew 1[1/s] (-1[1/s^2]) x, notch (-3[Hz]) 1[Hz] x
  --
  warning[W0309]: `highPass` has a negative time, which counts as zero
    --> limits.frob:20:19
     |
  20 |       , highPass (-1[s]) x, lowPassAngle (-1[s]) x, pid2 settings (x, 0), clamp (-1) 1 x ]
  --
  warning[W0309]: `lowPassAngle` has a negative time, which counts as zero
    --> limits.frob:20:43
     |
  20 |       , highPass (-1[s]) x, lowPassAngle (-1[s]) x, pid2 settings (x, 0), clamp (-1) 1 x ]
  --
  warning[W0316]: the lower limit of `clamp` is above the upper one
    --> limits.frob:21:13
     |
  21 |     , clamp 3 2 7
  --
  warning[W0316]: the lower limit of `hysteresis` is above the upper one
    --> limits.frob:22:19
     |
  22 |     , [hysteresis 2 1 x, pulse (-1[s]) b, onDelay 0[s] b] )
  --
  warning[W0309]: `pulse` has a negative time, which counts as zero
    --> limits.frob:22:33
     |
  22 |     , [hysteresis 2 1 x, pulse (-1[s]) b, onDelay 0[s] b] )
  --
  13 warnings

Other numbers that make no sense, and requirements in the program's own doc comments:

  $ cat > senseless.frob <<'FROB'
  > import Behaviour
  > import Control
  > import Filters
  > import Geometry
  > import Integration
  > import Matrix
  > import Motion
  > import Past
  > import Robot
  > 
  > -- | The part of a way that is left.
  > -- Requires: `way > 0`, `done >= 0`, `done <= way`.
  > left :: Distance -> Distance -> Float
  > left done way = (way - done) / way
  > 
  > -- | A wheel. Requires: `ticks >= 1`, `sum weights /= 0`.
  > data Wheel = Wheel { ticks :: Int, weights :: Array 2 Float }
  > 
  > main :: SF (Float, Bool) ((Float, Float, Float, Bool), (Float, Float, Float, Matrix 1 2), Maybe Float, Wheel)
  > main = proc (x, b) ->
  >     ( (delayBy (-1[s]) x, left 2[m] 1[m], fst (alphaBeta 2 (-0.1) x), heldFor (-1[s]) b)
  >     , ( movingAverage [1, -1] x, ranked (-1) [x, 1], rungeKutta alongLine 0 (\u y -> (u - y) / 1[s]) 0 x
  >       , jacobian 0 (\v -> [v ! 0]) [x, 2] )
  >     , settled (-1[s]) (sticky 1[s] (onlyIf b (left 0[m] 0[m]))), Wheel { ticks = 0, weights = [1, -1] } )
  > 
  > there :: (HasSonar i, DiffDrive o) => Task i o Bool
  > there = recover (-1) (followPath (pursuit { speed = 0 }) [zeroVec])
  > FROB
  $ frobc check senseless.frob 2>&1 | grep -A 3 warning
  warning[W0309]: `delayBy` has a negative time, which counts as zero
    --> senseless.frob:21:17
     |
  21 |     ( (delayBy (-1[s]) x, left 2[m] 1[m], fst (alphaBeta 2 (-0.1) x), heldFor (-1[s]) b)
  --
  warning[W0316]: the lower limit of `left` is above the upper one
    --> senseless.frob:21:32
     |
  21 |     ( (delayBy (-1[s]) x, left 2[m] 1[m], fst (alphaBeta 2 (-0.1) x), heldFor (-1[s]) b)
  --
  warning[W0316]: this is too large: `alphaBeta` needs a number of at most 1
    --> senseless.frob:21:58
     |
  21 |     ( (delayBy (-1[s]) x, left 2[m] 1[m], fst (alphaBeta 2 (-0.1) x), heldFor (-1[s]) b)
  --
  warning[W0316]: this is below zero: `alphaBeta` needs a number of at least 0
    --> senseless.frob:21:61
     |
  21 |     ( (delayBy (-1[s]) x, left 2[m] 1[m], fst (alphaBeta 2 (-0.1) x), heldFor (-1[s]) b)
  --
  warning[W0309]: `heldFor` has a negative time, which counts as zero
    --> senseless.frob:21:80
     |
  21 |     ( (delayBy (-1[s]) x, left 2[m] 1[m], fst (alphaBeta 2 (-0.1) x), heldFor (-1[s]) b)
  --
  warning[W0316]: these numbers add up to 0: `movingAverage` needs a nonzero sum
    --> senseless.frob:22:23
     |
  22 |     , ( movingAverage [1, -1] x, ranked (-1) [x, 1], rungeKutta alongLine 0 (\u y -> (u - y) / 1[s]) 0 x
  --
  warning[W0316]: this is below zero: `ranked` needs a number of at least 0
    --> senseless.frob:22:42
     |
  22 |     , ( movingAverage [1, -1] x, ranked (-1) [x, 1], rungeKutta alongLine 0 (\u y -> (u - y) / 1[s]) 0 x
  --
  warning[W0316]: this is too small: `rungeKutta` needs a number of at least 1
    --> senseless.frob:22:75
     |
  22 |     , ( movingAverage [1, -1] x, ranked (-1) [x, 1], rungeKutta alongLine 0 (\u y -> (u - y) / 1[s]) 0 x
  --
  warning[W0316]: this is too small: `jacobian` needs a number above 0
    --> senseless.frob:23:18
     |
  23 |       , jacobian 0 (\v -> [v ! 0]) [x, 2] )
  --
  warning[W0309]: `settled` has a negative time, which counts as zero
    --> senseless.frob:24:16
     |
  24 |     , settled (-1[s]) (sticky 1[s] (onlyIf b (left 0[m] 0[m]))), Wheel { ticks = 0, weights = [1, -1] } )
  --
  warning[W0316]: this is too small: `left` needs a number above 0
    --> senseless.frob:24:57
     |
  24 |     , settled (-1[s]) (sticky 1[s] (onlyIf b (left 0[m] 0[m]))), Wheel { ticks = 0, weights = [1, -1] } )
  --
  warning[W0316]: this is too small: `ticks` needs a number of at least 1
    --> senseless.frob:24:82
     |
  24 |     , settled (-1[s]) (sticky 1[s] (onlyIf b (left 0[m] 0[m]))), Wheel { ticks = 0, weights = [1, -1] } )
  --
  warning[W0316]: these numbers add up to 0: `weights` needs a nonzero sum
    --> senseless.frob:24:95
     |
  24 |     , settled (-1[s]) (sticky 1[s] (onlyIf b (left 0[m] 0[m]))), Wheel { ticks = 0, weights = [1, -1] } )
  --
  warning[W0316]: this is below zero: `recover` needs a number of at least 0
    --> senseless.frob:27:18
     |
  27 | there = recover (-1) (followPath (pursuit { speed = 0 }) [zeroVec])
  --
  warning[W0316]: this is too small: `speed` needs a number above 0
    --> senseless.frob:27:53
     |
  27 | there = recover (-1) (followPath (pursuit { speed = 0 }) [zeroVec])
  --
  15 warnings
