The module Pid, compared with an independent implementation: steps of uneven length, steps of
length 0, gaps, NaN for single instants, jumps of the setpoint, and a period of manual control.

  $ . ./models.sh
  $ cat > controllers.frob << 'FROB'
  > import Control
  > import Pid
  > gains, fast, plain :: Pid[1, 1]
  > gains = Pid { kp = 2, ki = 0.5[1/s], kd = 0.1[s], largest = 2 }
  > fast = gains { kd = 0.3[s] }
  > plain = Pid { kp = 1, ki = 0.5[1/s], kd = 0, largest = 2 }
  > rich :: PidSettings[1, 1]
  > rich = PidSettings { kp = 2, ki = 1[1/s], kd = 0.2[s], lowest = 0, highest = 1.5, b = 0.4, c = 0.3, tf = 0.1[s], start = Nothing }
  > main :: SF (Float, Angle, Float[1/s], Float, Bool, Bool, Float) (Float, Float, Float, Float, Float, Float)
  > main = proc (x, a, w, goal, _, _, m) ->
  >     ( pid2 (pidSettings gains) (goal, x), pid2 rich (goal, x)
  >     , pidWith (pidSettings fast) ((pidInput goal x) { rate = Just w })
  >     , pidWith ((pidSettings gains) { start = Just 1.25 }) ((pidInput goal x) { manual = if m == m then Just m else Nothing })
  >     , pidWith (pidSettings plain) ((pidInput goal x) { feedforward = w * 1[s] })
  >     , pidAngle (pidSettings gains) (goal, a)
  >     )
  > FROB
  $ models controllers
  double.c.csv: 2400 values, 0 differ
  float.c.csv: 2400 values, 0 differ

After a step of 99 s, `pid` and `pid2` leave the limit as soon as the error changes its sign. NaN at
one instant has no effect on later ones.

  $ . ./trace.sh
  $ cat > long.frob << 'FROB'
  > import Control
  > import Pid
  > gains :: Pid[m, V]
  > gains = Pid { kp = 2[V/m], ki = 0.5[V/m/s], kd = 0.1[V s/m], largest = 5[V] }
  > main :: SF Float[m] (Float[V], Float[V])
  > main = proc e -> (pid gains e, pid2 (pidSettings gains) (e, 0))
  > FROB
  $ trace long << ROWS | rounded
  > time,in
  > 0,1
  > 99,1
  > 99.1,1
  > 99.2,-1
  > 99.3,-1
  > 99.4,nan
  > 99.5,-1
  > 99.6,-1
  > ROWS
  time,out.1,out.2
  0,2,2
  99,5,5
  99.1,5,5
  99.2,1,1.05
  99.3,2.95,1
  99.4,nan,nan
  99.5,2.9,0.95
  99.6,2.85,0.9

Bumpless transfer: the first output is `start`, within the limits. When manual control ends, the
output continues from where it was. A controller without an integral part ignores both.

  $ cat > bumpless.frob << 'FROB'
  > import Control
  > import Pid
  > settings :: PidSettings[1, 1]
  > settings = (pidSettings Pid { kp = 2, ki = 1[1/s], kd = 0, largest = 5 }) { start = Just 3, lowest = 0 }
  > main :: SF (Float, Maybe Float) (Float, Float, Float)
  > main = proc (e, m) -> (pidWith settings i, pidWith (settings { start = Just 7 }) i, pidWith (settings { ki = 0 }) i) where
  >     i = (pidInput e 0) { manual = m }
  > FROB
  $ trace bumpless << ROWS | cells
  > time,in.1,in.2
  > 0,1,Nothing
  > 0.1,1,Nothing
  > 0.2,1,Just 1.5
  > 0.3,1,Just 9
  > 0.4,1,Just 2
  > 0.5,1,Nothing
  > 0.6,0.5,Nothing
  > ROWS
  3,5,2
  3.1000000000000001,5,2
  1.5,1.5,1.5
  5,5,5
  2,2,2
  2.1000000000000001,2.1000000000000001,2
  1.2,1.2,1

Limits that are upside down: the output is the lower limit. Angles: the settings are those of
numbers, and the input turns the shorter way.

  $ cat > upside_down.frob << 'FROB'
  > import Control
  > import Pid
  > plain :: Pid[1, 1]
  > plain = Pid { kp = 1, ki = 0, kd = 0, largest = 5 }
  > main :: SF (Angle, Angle) (Float, Float, Angle)
  > main = proc (goal, heading) -> (pid2 settings (goal, heading), pidAngle (pidSettings plain) (goal, heading), (angleInput (goal, heading)).setpoint) where
  >     settings = (pidSettings plain) { lowest = high, highest = -1 }
  >     high = 1
  > FROB
  $ printf '%s\n' 1,0 3,-3 -3,3 | rows in.1,in.2 | trace upside_down | cells | rounded
  1,1,1
  1,-0.283185307,-3.28318531
  1,0.283185307,-3
