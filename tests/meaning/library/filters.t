The module Filters, compared with an independent implementation: steps of uneven length, steps of
length 0, gaps, outliers, and NaN for single instants.

  $ . ./models.sh
  $ cat > filters.frob << 'FROB'
  > import Filters
  > type Ten = (Float, Float[1/s], Float[1/s], Float, (Float, Float[1/s]), Float, Float, Float, Float)
  > main :: SF (Float, Angle, Float[1/s], Float, Bool, Bool, Float) (Ten, (Float, Float, Float, Float, Float, Float))
  > main = proc (x, _, w, _, _, _, _) ->
  >     ( ( highPass 0.3[s] x, filteredDerivative 0.1[s] x, filteredDerivative 0[s] x
  >       , complementary 0.5[s] (w, x), alphaBeta 0.5 0.2 x
  >       , lowPass2 3[Hz] x, (stateVariable 3[Hz] (sqrt 0.5) x).high, notch 8[Hz] 2[Hz] x
  >       , rateLimitUpDown 1[1/s] 3[1/s] 0.2 x )
  >     , ( median3 x, median5 x, median (recent x :: Array 7 Float), median (recent x :: Array 4 Float)
  >       , hampel 3 (recent x :: Array 7 Float), rejectJumps 0.5 0.15[s] x )
  >     )
  > FROB
  $ models filters
  double.c.csv: 6400 values, 0 differ
  float.c.csv: 6400 values, 0 differ

With steps of constant length, the filters of second order are the usual biquads.

  $ cat > biquads.frob << 'FROB'
  > import Filters
  > main :: SF (Float, Angle, Float[1/s], Float, Bool, Bool, Float) (Float, Float, Float, Float)
  > main = proc (x, _, _, _, _, _, _) ->
  >     (lowPass2 3[Hz] x, (stateVariable 3[Hz] (sqrt 0.5) x).high, (stateVariable 3[Hz] 2 x).band, notch 8[Hz] 2[Hz] x)
  > FROB
  $ models biquads steady
  double.c.csv: 1600 values, 0 differ
  float.c.csv: 1600 values, 0 differ

The fastest motion within the limits, compared with a simulation in steps of 0.02 ms that brakes
when it reaches the switching curve. The goal jumps at random.

  $ cat > motions.frob << 'FROB'
  > import Filters
  > main :: SF (Float, Angle, Float[1/s], Float, Bool, Bool, Float) (Float, Float[1/s])
  > main = proc (_, _, _, goal, _, _, _) -> (slew 1[1/s] 2[1/s^2] goal, (slewAfter 1[1/s] 2[1/s^2] Nothing goal).speed)
  > FROB
  $ models motions
  double.c.csv: 800 values, 0 differ
  float.c.csv: 800 values, 0 differ

From a start to a goal, with a peak below the speed limit and with a cruise. It arrives exactly,
after the time that the formulas predict (2 s and 3.5 s), and stays there. A limit of 0 or less
stops it; a longer step than `controlStep` allows moves it no farther.

  $ . ./trace.sh
  $ cat > ways.frob << 'FROB'
  > import Filters
  > main :: SF Float (Motion[1], Motion[1], Motion[1], Motion[1])
  > main = proc x ->
  >     ( slewFrom 0 9[1/s] 1[1/s^2] 1, slewFrom 5 2[1/s] 2[1/s^2] 0, slewFrom 1 9[1/s] no 2
  >     , trapezoid 1[1/s] 1[1/s^2] 0.5[s] x Motion { position = 0, speed = 1[1/s] } )
  >   where no = -1[1/s^2]
  > FROB
  $ trace ways << ROWS | cells
  > time,in
  > 0,1
  > 0.5,2
  > 1,0.5
  > 1.5,-1
  > 2,0
  > 2.5,0
  > 3,0
  > 3.5,0
  > 4,0
  > 60,0
  > ROWS
  0,0,5,-0,1,0,0.5,1
  0.125,0.5,4.75,-1,1,0,0.5,1
  0.5,1,4,-2,1,0,0.375,0.5
  0.875,0.5,3,-2,1,0,0.375,0.5
  1,0,2,-2,1,0,0.375,0.5
  1,0,1,-2,1,0,0.375,0.5
  1,0,0.25,-1,1,0,0.375,0.5
  1,0,0,0,1,0,0.375,0.5
  1,0,0,0,1,0,0.375,0.5
  1,0,0,0,1,0,0.375,0.5

Other edges: the frequency 0, a width of 0, limits of 0 or less, arrays with NaN and infinities,
numbers that are as large as a Float can be.

  $ cat > edges.frob << 'FROB'
  > import Control
  > import Filters
  > main :: SF Float ((Float, Float, Float, Float, Float), (Float, Float, Float, Float), (Bool, Maybe Float, Time))
  > main = proc x ->
  >     ( ( lowPass2 0[Hz] x, notch 2[Hz] none x, rateLimitUpDown (1[1/s] * less) 1[1/s] 9 x
  >       , rateLimitUpDown 9[1/s] 9[1/s] less x, highPass (1[s] * less) x )
  >     , (median [x, 1, 2], median [x, x, 1, 1], ranked 0 [3, x, 2], middle x 1 3)
  >     , (isFinite x, lastFinite x, stepSince (isFinite x)) )
  >   where
  >     none = 0[Hz]
  >     less = -1
  > FROB
  $ printf '%s\n' 1 3 -2 nan inf 1e300 -1e300 0 | rows in | trace edges | cells
  1,1,1,1,0,1,1,1,1,true,Nothing,0
  1,3,1,1,0,2,2,2,3,true,Just 1,1
  1,-2,0,1,0,1,-0.5,-2,1,true,Just 3,1
  nan,nan,nan,nan,nan,nan,nan,nan,nan,false,Just (-2),1
  nan,inf,0,1,nan,2,inf,2,3,false,Just (-2),2
  1,1.0000000000000001e+300,0,1,0,2,5.0000000000000003e+299,2,3,true,Just (-2),3
  1,-1.0000000000000001e+300,-1,1,0,1,-5.0000000000000003e+299,-1.0000000000000001e+300,1,true,Just 1.0000000000000001e+300,1
  1,0,-1,1,0,1,0.5,0,1,true,Just (-1.0000000000000001e+300),1
