The building blocks of controllers. awk computes the time-dependent ones a second time, on uneven
steps and one of length 0.

  $ . ./trace.sh
  $ cat > uneven.csv << ROWS
  > time,in
  > 10,1
  > 10.1,3
  > 10.1,4
  > 12.5,0
  > 12.75,-1
  > 12.76,-1.5
  > 13,-1.5
  > 13.5,-1.5
  > ROWS
  $ model() {
  >   trace "$1" < uneven.csv | cells | rounded > found
  >   awk -F, 'function limit(l, x) { return x > l ? l : x < -l ? -l : x }
  >     NR == 1 { next } { x = $2; start = NR == 2; dt = start ? 0 : $1 - t; t = $1 }'"$2"'
  >     { before = x }' uneven.csv | diff - found
  > }

Limits, on Float and on Int:

  $ cat > limits.frob << FROB
  > import Control
  > main :: SF (Float, Int) (Float, Float, Float, Int, Int, Int)
  > main = proc (x, n) -> (limit 2 x, clamp (-1) 3 x, deadband 2 x, limit 2 n, clamp (-1) 3 n, deadband 2 n)
  > FROB
  $ printf '%s\n' 0.5,0 2,2 -7,-7 5,5 nan,3 inf,2147483647 | rows in.1,in.2 | trace limits | cells
  0.5,0.5,0,0,0,0
  2,2,0,2,2,0
  -2,-1,-5,-2,-1,-5
  2,3,3,2,3,3
  nan,nan,nan,2,3,1
  2,3,inf,2,3,2147483645
  $ single limits

Limits below zero count as 0, and of two limits that are swapped, the lower one wins:

  $ cat > negative.frob << FROB
  > import Control
  > main :: SF (Float, Float) ((Float, Float, Int, Float), (Float, Float, Bool))
  > main = proc (x, y) ->
  >     ( (limit x y, deadband x y, limit (round x) (round y), clamp 1 x y)
  >     , (slow 1 y, control 1 y, swapped 3 y) )
  > 
  > slow, control :: Float -> SF Float Float
  > slow x = rateLimit (-x / 1[s])
  > control x = pid Pid { kp = 1, ki = 1[1/s], kd = 1[s], largest = -x }
  > swapped :: Float -> SF Float Bool
  > swapped x = hysteresis (x + 2) x
  > FROB
  $ printf '%s\n' -2,7 -2,0.5 -2,-7 nan,4 -2,4 | rows in.1,in.2 | trace negative | cells
  -0,7,0,1,7,-0,true
  -0,0.5,0,1,7,-0,false
  -0,-7,0,1,7,-0,false
  nan,nan,0,nan,7,-0,true
  -0,4,0,1,7,-0,true
  $ single negative

The first instant, the length of a step, the part of it that controllers count, and the previous
input:

  $ cat > steps.frob << FROB
  > import Control
  > main :: SF Float (Bool, Time, Time, Float)
  > main = proc x -> (atStart x, stepTime x, controlStep x, previous x)
  > FROB
  $ model steps '{
  >     most = usual > 0.1 ? 2 * usual : 0.2; step = usual > 0 && dt > most ? most : dt
  >     if (step > 0) usual = step
  >     printf "%s,%.9g,%.9g,%.9g\n", start ? "true" : "false", dt, step, start ? x : before
  >   }'
  $ single steps

Filters: a first-order low-pass, also with a time constant of 0 or less, which disables it; a slope
limit, which counts no step as longer than twice the one before; a mean.

  $ cat > filters.frob << FROB
  > import Control
  > main :: SF Float (Float, Float, Float, Float)
  > main = proc x -> (lowPass 0.5[s] x, without 1[s] x, rateLimit 2[1/s] x, movingAverage [1, 1, 1, 1] x)
  > 
  > without :: Time -> SF Float Float
  > without tau = lowPass (-tau)
  > FROB
  $ model filters '{
  >     y = start ? x : y + dt / (0.5 + dt) * (x - y)
  >     z = start || dt > 0 ? x : z
  >     most = usual > 0.1 ? 2 * usual : 0.2; step = usual > 0 && dt > most ? most : dt
  >     if (step > 0) usual = step
  >     r = start ? x : r + limit(2 * step, x - r)
  >     if (start) x1 = x2 = x3 = x
  >     printf "%.9g,%.9g,%.9g,%.9g\n", y, z, r, (x + x1 + x2 + x3) / 4
  >     x3 = x2; x2 = x1; x1 = x
  >   }'
  $ single filters

A window contains the last inputs, newest first; optionally with weights.

  $ cat > windows.frob << FROB
  > import Control
  > main :: SF Float (Array 3 Float, Float, Float, Array 2 Int)
  > main = proc x -> (window 0 x, movingAverage [3, 0, -1] x, movingAverage [0.5] x, shift 1 [2, 3])
  > FROB
  $ printf '%s\n' 1 2 4 8 | rows in | trace windows | cells
  1,0,0,1,1,1,2
  2,1,0,2.5,2,1,2
  4,2,1,5.5,4,1,2
  8,4,2,11,8,1,2
  $ single windows

The fraction of the difference by which a low-pass moves in a step:

  $ cat > approaches.frob << FROB
  > import Control
  > main :: SF (Time, Time) Float
  > main = proc (tau, step) -> approach tau step
  > FROB
  $ printf '%s\n' 3,1 3,0 0,1 0,0 -1,1 1,inf inf,1 | rows in.1,in.2 | trace approaches | cells | xargs
  NaN: out, first at 5.000 s; to find its origin, run `frobc view --why-nan`
  0.25 0 1 0 1 nan 0

`hysteresis 1 3` is on from 3 until 1:

  $ cat > switches.frob << FROB
  > import Control
  > main :: SF Float Bool
  > main = proc x -> hysteresis 1 3 x
  > FROB
  $ printf '%s\n' 2 3 2 1.5 1 2 2.9 9 nan 9 0 | rows in | trace switches | cells | xargs
  false true true true false false false true false true false

`debounce 0.3[s]` changes once its input has been different for 0.3 s; a shorter
change restarts the clock. The first input is used as it is.

  $ cat > bounces.frob << FROB
  > import Control
  > main = debounce 0.3[s]
  > FROB
  $ trace bounces << ROWS | cells | xargs
  > time,in
  > 0,true
  > 0.1,false
  > 0.2,false
  > 0.3,true
  > 0.4,false
  > 0.5,false
  > 0.6,false
  > 0.7,false
  > 2.0,true
  > 2.1,false
  > 2.2,true
  > 2.5,true
  > ROWS
  true true true true true true true false false false false true

A PID controller with all three parts, whose integral does not change while the output is at its
limit and the error would push it further. A step does not count as longer than twice the one
before, or 0.2 s:

  $ cat > controller.frob << FROB
  > import Control
  > main :: SF Float[m] Float[V]
  > main = pid Pid { kp = 2[V/m], ki = 0.5[V/m/s], kd = 0.1[V s/m], largest = 5[V] }
  > FROB
  $ model controller '{
  >     most = usual > 0.1 ? 2 * usual : 0.2; step = usual > 0 && dt > most ? most : dt
  >     if (step > 0) usual = step
  >     sum = start ? 0 : limit(5, sum + step * counted)
  >     slope = start ? 0 : dt > 0 ? (x - before) / dt : slope
  >     wanted = 2 * x + sum + 0.1 * slope
  >     counted = (wanted > 5 && x > 0 || wanted < -5 && x < 0) ? 0 : 0.5 * x
  >     printf "%.9g\n", limit(5, wanted)
  >   }'
  $ single controller
