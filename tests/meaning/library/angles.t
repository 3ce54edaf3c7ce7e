The module Angles, compared with an independent implementation that represents angles by complex
numbers: steps of uneven length, steps of length 0, gaps, NaN for single instants, and a
heading that often wraps.

  $ . ./models.sh
  $ cat > angles.frob << 'FROB'
  > import Angles
  > main :: SF (Float, Angle, Float[1/s], Float, Bool, Bool, Float) ((Angle, AngularVelocity, Angle, Angle), (Angle, Angle, Angle))
  > main = proc (_, a, w, goal, _, _, _) ->
  >     ( (unwrap a, angularRate a, lowPassAngle 0.3[s] a, rateLimitAngle 2[rad/s] a)
  >     , (meanAngle [a, goal], movingAverageAngle [3, 2, 1, 1] a, complementaryAngle 0.5[s] (w, a))
  >     )
  > FROB
  $ models angles
  double.c.csv: 2800 values, 0 differ
  float.c.csv: 2800 values, 0 differ

A derivative, a low-pass filter and a mean of a heading that turns slowly through the wrap, each
plain and from this module:

  $ . ./trace.sh
  $ cat > wrap.frob << 'FROB'
  > import Angles
  > import Control
  > main :: SF Angle (Array 6 Int)
  > main = proc a -> map round
  >     [ derivative a * 1[s], angularRate a * 1[s]
  >     , lowPass 1[s] a / 1[deg], lowPassAngle 1[s] a / 1[deg]
  >     , movingAverage [1, 1] a / 1[deg], movingAverageAngle [1, 1] a / 1[deg] ]
  > FROB
  $ printf '%s\n' 3.04 3.14 -3.04 -2.94 | rows in | trace wrap | cells
  0,0,174,174,174,174
  0,0,177,177,177,177
  -6,0,1,-179,3,-177
  0,0,-84,-174,-171,-171

The edges: exactly half a turn, two opposite directions, no weight, and negative limits.

  $ cat > edges.frob << 'FROB'
  > import Angles
  > main :: SF Angle (Array 7 Int)
  > main = proc a -> map (\x -> round (x / 1[deg]))
  >     [ unwrap a, halfOpen a, meanAngle [a, a + pi], movingAverageAngle [0, 0] a
  >     , lowPassAngle (-tau) a, rateLimitAngle (-rate) a, meanAngle [a, a] ]
  >   where
  >     tau = 1[s]
  >     rate = 1[rad/s]
  > FROB
  $ printf '%s\n' 0 3.14159265358979323846 -3.14159265358979323846 | rows in | trace edges | cells
  0,0,90,0,0,0,0
  180,180,-90,0,180,0,180
  180,180,-90,0,180,0,180
