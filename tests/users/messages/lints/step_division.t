A division by the length of the step, which is 0 at the first instant; also through an equation that
is that length, and by a multiple of it. Inside a branch there is no warning.

  $ cat > slopes.frob <<'FROB'
  > import Control
  > 
  > main :: SF Float (Float, Float, Float, Float, Float)
  > main = proc x -> (x / step, x * 1[s] / stepTime (), safe, x * 1[s] / (2 * half), x / 2) where
  >     step = stepTime () / 1[s]
  >     half = stepTime () / 2
  >     safe = if step > 0 then x / step else 0
  > FROB
  $ frobc check slopes.frob
  warning[W0314]: this divides by the length of the step, which is 0 at the first instant
   --> slopes.frob:4:19
    |
  4 | main = proc x -> (x / step, x * 1[s] / stepTime (), safe, x * 1[s] / (2 * half), x / 2) where
    |                   ^^^^^^^^
    |
    = note: at that instant the quotient is infinite, or NaN if the dividend is also 0
    = hint: for the slope of a signal, use `derivative`; otherwise divide only in a branch where the step is longer than 0
  
  warning[W0314]: this divides by the length of the step, which is 0 at the first instant
   --> slopes.frob:4:29
    |
  4 | main = proc x -> (x / step, x * 1[s] / stepTime (), safe, x * 1[s] / (2 * half), x / 2) where
    |                             ^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: at that instant the quotient is infinite, or NaN if the dividend is also 0
    = hint: for the slope of a signal, use `derivative`; otherwise divide only in a branch where the step is longer than 0
  
  warning[W0314]: this divides by the length of the step, which is 0 at the first instant
   --> slopes.frob:4:59
    |
  4 | main = proc x -> (x / step, x * 1[s] / stepTime (), safe, x * 1[s] / (2 * half), x / 2) where
    |                                                           ^^^^^^^^^^^^^^^^^^^^^
    |
    = note: at that instant the quotient is infinite, or NaN if the dividend is also 0
    = hint: for the slope of a signal, use `derivative`; otherwise divide only in a branch where the step is longer than 0
  
  3 warnings
