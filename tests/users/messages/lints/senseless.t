Constants that are certainly mistakes: NaN, values that wrap around, negative times. Each is
reported where it is computed, not where it is used.

  $ cat > nan.frob <<'FROB'
  > gain :: Float
  > gain = sqrt (1 - low * 2)
  > 
  > low :: Float
  > low = 4
  > 
  > unknown :: Float
  > unknown = 0 / 0
  > 
  > main :: SF Float (Float, Float, Float, Float)
  > main = proc x -> (gain * x, 2 * gain, unknown, log (-1) + x)
  > FROB
  $ frobc check nan.frob
  warning[W0307]: this is always NaN (not a number)
   --> nan.frob:2:8
    |
  2 | gain = sqrt (1 - low * 2)
    |        ^^^^^^^^^^^^^^^^^^
    |
    = note: every comparison with NaN is False, and every result computed from NaN is NaN
  
  warning[W0307]: this is always NaN (not a number)
    --> nan.frob:11:48
     |
  11 | main = proc x -> (gain * x, 2 * gain, unknown, log (-1) + x)
     |                                                ^^^^^^^^
     |
     = note: every comparison with NaN is False, and every result computed from NaN is NaN
  
  2 warnings

  $ cat > ints.frob <<'FROB'
  > steps :: Int
  > steps = 65536
  > 
  > main :: SF Int (Int, Int, Int)
  > main = proc n -> (steps * steps, -2147483648, n * 65536 * 65536)
  > FROB
  $ frobc check ints.frob
  warning[W0308]: this is 4294967296, which is out of range for an `Int`: it wraps around to 0
   --> ints.frob:5:19
    |
  5 | main = proc n -> (steps * steps, -2147483648, n * 65536 * 65536)
    |                   ^^^^^^^^^^^^^
    |
    = note: an `Int` must be between -2147483648 and 2147483647
    = hint: use Floats, or a larger unit
  
  1 warning

  $ cat > times.frob <<'FROB'
  > import Control
  > pause :: Time
  > pause = -3[s]
  > 
  > main :: SF Float (Float, Event (), Either Float (Maybe ()))
  > main = proc x -> (lowPass (0.1[s] - 0.2[s]) x, every 0[s] (), runTask (sleepT pause 1 `timeOut` (-1[ms])) ())
  > FROB
  $ frobc check times.frob
  warning[W0309]: `lowPass` has a negative time, which counts as zero
   --> times.frob:6:28
    |
  6 | main = proc x -> (lowPass (0.1[s] - 0.2[s]) x, every 0[s] (), runTask (sleepT pause 1 `timeOut` (-1[ms])) ())
    |                            ^^^^^^^^^^^^^^^
    |
    = hint: write a time of at least `0[s]`
  
  warning[W0309]: `sleepT` has a negative time, which counts as zero
   --> times.frob:6:79
    |
  6 | main = proc x -> (lowPass (0.1[s] - 0.2[s]) x, every 0[s] (), runTask (sleepT pause 1 `timeOut` (-1[ms])) ())
    |                                                                               ^^^^^
    |
    = hint: write a time of at least `0[s]`
  
  warning[W0309]: `timeOut` has a negative time, which counts as zero
   --> times.frob:6:98
    |
  6 | main = proc x -> (lowPass (0.1[s] - 0.2[s]) x, every 0[s] (), runTask (sleepT pause 1 `timeOut` (-1[ms])) ())
    |                                                                                                  ^^^^^^
    |
    = hint: write a time of at least `0[s]`
  
  3 warnings
