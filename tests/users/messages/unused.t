What nothing uses: a rule that was never wired in is told at its equation.

  $ cat > never_wired.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0[1/s]) where
  >     near = frontSonar i < 0.3[m]
  >     stop = near || bumped i
  >     v = 0.2[m/s])
  > FROB
  $ frobc check never_wired.frob
  warning[W0304]: `stop` is defined here, and nothing uses it
   --> never_wired.frob:5:5
    |
  5 |     stop = near || bumped i
    |     ^^^^
    |
    = hint: use it in what comes out, or take it out; `_stop` says that this is meant
  
  1 warning

Equations that use each other only, one that uses itself, a pattern of which nothing
is used and one of which a part is, what a task ends with:

  $ cat > circles.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> x + low where
  >     a = delay 0 b
  >     b = a + 1
  >     n = delay 0 (n + 1)
  >     (p, q) = (x, delay 0 p)
  >     (low, high) = (min 0 x, max 0 x)
  > 
  > twice :: Task Float Float ()
  > twice = do
  >     let k = 2
  >     r <- sleepT 1[s] 0
  >     sleepT 1[s] 1
  > FROB
  $ frobc check circles.frob
  warning[W0304]: `a` is defined here, and nothing uses it
   --> circles.frob:3:5
    |
  3 |     a = delay 0 b
    |     ^
    |
    = note: `a` and `b` use only each other
    = hint: use it in what comes out, or take it out; `_a` says that this is meant
  
  warning[W0304]: `n` is defined here, and nothing uses it
   --> circles.frob:5:5
    |
  5 |     n = delay 0 (n + 1)
    |     ^
    |
    = note: only its own equation reads it
    = hint: use it in what comes out, or take it out; `_n` says that this is meant
  
  warning[W0304]: these are defined here, and nothing uses them
   --> circles.frob:6:5
    |
  6 |     (p, q) = (x, delay 0 p)
    |     ^^^^^^
    |
    = note: only its own equation reads it
    = hint: use one of them in what comes out, or take the equation out
  
  warning[W0305]: nothing reads `high`
   --> circles.frob:7:11
    |
  7 |     (low, high) = (min 0 x, max 0 x)
    |           ^^^^
    |
    = hint: write `_` in its place, or `_high`
  
  warning[W0304]: `k` is defined here, and nothing uses it
    --> circles.frob:11:9
     |
  11 |     let k = 2
     |         ^
     |
     = hint: use it in what comes out, or take it out; `_k` says that this is meant
  
  warning[W0305]: nothing reads `r`
    --> circles.frob:12:5
     |
  12 |     r <- sleepT 1[s] 0
     |     ^
     |
     = hint: write `_` in its place, or `_r`
  
  6 warnings

A name with `_` in front is silent, and so is what it uses; a program with errors is
told of these first.

  $ cat > silent.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> x where
  >     a = 2 * x
  >     _later = a + 1
  >     (_b, _c) = (x, x)
  >     f _y = x
  >     _ = f 1
  > 
  > fourth :: Float -> Float
  > fourth _x = 4
  > FROB
  $ frobc check silent.frob
  $ sed 's/x where/z where/; s/_later/later/' silent.frob > faulty.frob
  $ frobc check faulty.frob
  error[E0205]: unknown name `z`
   --> faulty.frob:2:18
    |
  2 | main = proc x -> z where
    |                  ^
  
  1 error
  [1]
