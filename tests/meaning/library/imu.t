The module Imu, compared with an independent implementation: readings at some instants, with and
without a magnetometer, with NaN for single instants, and after gaps.

  $ . ./models.sh
  $ cat > imu.frob << 'FROB'
  > import Geometry
  > import Imu
  > data Unit = Unit { reading :: Event Imu }
  > instance HasImu Unit where
  >     imu u = u.reading
  > main :: SF (Float, Angle, Float[1/s], Float, Bool, Bool, Float) Angle
  > main = proc (_, a, w, _, arrives, noCompass, _) -> imuHeading 0.5[s] Unit
  >     { reading = tag (when arrives) Imu
  >         { rate = Vec3 { x = 0, y = 0, z = w }, acceleration = Vec3 { x = 0, y = 0, z = 9.81[m/s^2] }
  >         , heading = if noCompass then Nothing else Just a, age = 0, number = 0 } }
  > FROB
  $ models imu
  double.c.csv: 400 values, 0 differ
  float.c.csv: 400 values, 0 differ

The last reading is kept until the next one:

  $ . ./trace.sh
  $ cat > kept.frob << 'FROB'
  > import Geometry
  > import Imu
  > data Unit = Unit { reading :: Event Imu }
  > instance HasImu Unit where
  >     imu u = u.reading
  > main :: SF (Bool, Float) (Float, Float, Maybe Angle)
  > main = proc (arrives, x) -> (gyroRate i * 1[s], forwardAcceleration i / 1[m/s^2], compassHeading i) where
  >     i = Unit { reading = tag (when arrives) (measured x) }
  > 
  > measured :: Float -> Imu
  > measured x = Imu
  >     { rate = Vec3 { x = 0, y = 0, z = x * 1[1/s] }
  >     , acceleration = Vec3 { x = -x * 1[m/s^2], y = 0, z = 0 }
  >     , heading = if x > 2 then Just x else Nothing, age = 0, number = 0 }
  > FROB
  $ printf '%s\n' false,1 true,2 false,3 true,3 false,4 | rows in.1,in.2 | trace kept | cells
  0,0,Nothing
  2,-2,Nothing
  2,-2,Nothing
  3,-3,Just 3
  3,-3,Just 3
