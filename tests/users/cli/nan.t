The summary of a trace lists the outputs that were NaN, and since when; `frobc view --why-nan` finds
the origin: here an equation whose value was stored for an instant, and one with two infinities.

  $ cat > rates.frob << FROB
  > main :: SF Float (Float, Float, Float)
  > main = proc x -> (forward, other, x) where
  >     forward = integral (rate * 1[m]) / 1[m s]
  >     rate = if x > 3 then sqrt (2 - x) else kept
  >     kept = delay 0 x
  >     other = 3 / half - 6 / half
  >     half = x - 2
  > FROB
  $ printf 'time,in\n0,1\n1,2\n2,2.5\n3,4\n4,1\n5,1\n' > in.csv
  $ frobc trace rates.frob --input in.csv
  time,out.1,out.2,out.3
  0.000000000,0,3,1
  1.000000000,0,nan,2
  2.000000000,1,-6,2.5
  3.000000000,3,-1.5,4
  4.000000000,nan,3,1
  5.000000000,nan,3,1
  NaN: out.1, first at 4.000 s; to find its origin, run `frobc view --why-nan`
  NaN: out.2, first at 1.000 s
  $ frobc view in.csv rates.frob --why-nan
  NaN: out.1, first at 4.000 s, from main.rate at rates.frob:4, NaN since 3.000 s
  NaN: out.2, first at 1.000 s, from main.other at rates.frob:6

NaN in the input is not reported, because the author of the input can see it. `frobc view --why-nan`
finds it as an origin:

  $ printf 'time,in\n0,1\n1,nan\n2,1\n3,1\n' > in.csv
  $ frobc trace rates.frob --input in.csv | tail -1
  3.000000000,nan,3,1
  $ frobc view in.csv rates.frob --why-nan
  NaN: out.1, first at 3.000 s, from the input in, NaN since 1.000 s
  NaN: out.2, first at 1.000 s, from the input in
  NaN: out.3, first at 1.000 s, from the input in

An assertion that was violated because of NaN:

  $ cat > asserts.frob << FROB
  > main :: SF Float Bool
  > main = proc x -> y < 9 where
  >     y = sqrt (x - 1)
  >     assert "small" (y < 1)
  > FROB
  $ printf 'time,in\n0,1\n1,0.5\n' > in.csv
  $ frobc trace asserts.frob --input in.csv
  time,out
  0.000000000,true
  1.000000000,false
  assert "small": violated, first at 1.000 s; in total at 1 instant
  $ frobc view in.csv asserts.frob --why-nan
  NaN: assert "small", violated at 1.000 s, from main.y at asserts.frob:3

The summary of a run also reports NaN; outputs without NaN are not mentioned:

  $ cat > drives.frob << FROB
  > import Robot
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (proc i -> roMake (setVelTR (speed i) 0))
  > speed :: SF RobotInput Velocity
  > speed = proc _ -> v where
  >     t = time ()
  >     v = if t > 2[s] then sqrt (2 - t / 1[s]) * 1[m/s] else 0.1[m/s]
  > FROB
  $ frobc run drives.frob --for 3s --record run.csv | grep NaN
  NaN: out.forward, first at 2.020 s; to find its origin, run `frobc view --why-nan`
  $ frobc view run.csv drives.frob --why-nan
  NaN: out.forward, first at 2.020 s, from speed.v at drives.frob:7
  $ frobc run drives.frob --for 1s | grep NaN
  [1]
  $ frobc run drives.frob --for 1s --record run.csv > summary
  $ frobc view run.csv drives.frob --why-nan
