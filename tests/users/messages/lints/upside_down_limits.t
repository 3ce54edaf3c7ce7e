Limits that are upside down or negative are reported where they are constants, also times below zero.

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
  warning[W0316]: this is below zero: `tf` needs a number of at least 0
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
