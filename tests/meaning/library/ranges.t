Every library function whose documentation states a range stays within it at the extremes of its
input: zeros, the least and the largest numbers, infinities, and whole and half turns and their
neighbours up to three bits away. Both engines, in double and in single precision. A result may be
NaN only if an argument is NaN or infinite.

  $ . ./trace.sh
  $ cat > edges.py << 'PY'
  > import itertools, math, random, sys
  > def beside(x):
  >     yield x
  >     for towards in (math.inf, -math.inf):
  >         y = x
  >         for _ in range(3):
  >             y = math.nextafter(y, towards)
  >             yield y
  > small = [0.0, -0.0, 5e-324, 2.3e-308, 1e-45, 1e-30, 2.0**-53, 2.0**-24, 0.5, 1.0, 2.0, 1000.0]
  > large = [2.0**23, 2.0**24, 2.0**31, 2.0**52, 2.0**53, 1e16, 1e17, 3e38, 1e300, sys.float_info.max]
  > turns = [k * math.pi / 2 for k in [*range(1, 45), 200, 201, 10**4 + 1, 10**6 + 1, 10**9 + 1, 10**12 + 1]]
  > issue = [34.55751918948772]
  > numbers = sorted({y for x in small + large + turns + issue for y in [*beside(x), *beside(-x)]}) + [-0.0]
  > if sys.argv[1] == "one":
  >     rows = [(x,) for x in numbers] + [(math.inf,), (-math.inf,), (math.nan,)]
  > else:
  >     few = [0.0, -0.0, 5e-324, -1e-45, 0.3, -0.5, 1.0, -1.0, math.pi, -math.pi, 3 * math.pi, 7.0, 1e16, -1e300, sys.float_info.max, math.inf, -math.inf]
  >     random.seed(1)
  >     rows = [*itertools.product(few, few)] + [tuple(random.choices(numbers, k=2)) for _ in range(600)]
  > print("time," + ",".join(sys.argv[2:]))
  > for k, row in enumerate(rows):
  >     print(k, *map(repr, row), sep=",")
  > PY

`judge NAME` prints the number of rows, and the first of those in which a Bool is false. Single
precision rejects a number that only double precision can represent, so infinity replaces it.

  $ cat > single.py << 'PY'
  > import math
  > import sys
  > for k, line in enumerate(sys.stdin):
  >     time, *cells = line.rstrip("\n").split(",")
  >     if k > 0:
  >         cells = [x if abs(float(x)) < 3.4028235e38 or x == "nan" else repr(math.copysign(math.inf, float(x))) for x in cells]
  >     print(time, *cells, sep=",")
  > PY
  $ judge() {
  >   cp edges.csv double.csv && python3 single.py < edges.csv > float.csv
  >   for real in double float; do
  >     frobc trace --real $real "$1.frob" --input $real.csv --output compiled.csv
  >     frobc trace --real $real "$1.frob" --input $real.csv --output interpreted.csv --engine interp
  >     cmp compiled.csv interpreted.csv
  >     echo "$real: $(sed 1d compiled.csv | wc -l) rows, $(grep -c false compiled.csv) broken"
  >     grep -m 3 false compiled.csv | cut -d, -f1 | while read -r t; do sed -n "$((${t%.*} + 2))p" edges.csv; done
  >   done
  > }

Functions of one number. An angle that is already in the range does not change; a wrapped one
differs by whole turns, as precisely as arithmetic with so large a number allows.

  $ cat > one.frob << 'FROB'
  > import Geometry
  > import Sources
  > inside :: Float -> Float -> Float -> Float -> Bool
  > inside x low high y = (y >= low && y <= high) || (y /= y && x - x /= x - x)
  > isAngle :: Float -> Angle -> Bool
  > isAngle x y = (y > -pi && y <= pi) || (y /= y && x - x /= x - x)
  > isWave, isSquare :: (Float, Float, Float) -> Bool
  > isWave (a, b, c) = abs a <= 1 && abs b <= 1 && abs c <= 1
  > isSquare (a, b, c) = abs a == 1 && abs b == 1 && abs c == 1
  > looking :: Float -> Pose
  > looking x = Pose { position = zeroVec, heading = x }
  > main :: SF Float ((Bool, Bool, Bool, Bool), (Bool, Bool, Bool, Bool), (Bool, Bool, Bool, Bool), (Bool, Bool, Bool), (Bool, Bool, Bool), Bool)
  > main = proc x -> let
  >     w = wrapAngle x
  >     s = (sine 0.3[Hz] x, sine (-1e-40[Hz]) x, sine 1e17[Hz] x)
  >     q = (squareWave 0.25[Hz] x, squareWave (-1e-40[Hz]) x, squareWave 1e17[Hz] x)
  >     c1 = chirp 0.3[Hz] (-2[Hz]) 200[s] x
  >     c2 = chirp 1e17[Hz] 3[Hz] 0[s] x
  >     f = fraction x
  >   in
  >   ( ( isAngle x w
  >     , if x > -pi && x <= pi then w == x else True
  >     , if abs x < 1000 then abs (sin w - sin x) < 0.001 && abs (cos w - cos x) < 0.001 else True
  >     , isAngle x (compose (looking x) (looking 3)).heading && isAngle x (inverse (looking x)).heading
  >     )
  >   , (inside x (-1) 1 (sin x), inside x (-1) 1 (cos x), inside x (-pi / 2) (pi / 2) (atan x), inside x 0 x (sqrt x) || x < 0 || x < 1)
  >   , ( if abs x <= 1 then asin x >= -pi / 2 && asin x <= pi / 2 else True, if abs x <= 1 then acos x >= 0 && acos x <= pi else True
  >     , inside x (-1) 1 (signum x) && (signum x == 0 || abs (signum x) == 1 || x /= x), abs x >= 0 || x /= x
  >     )
  >   , (isWave s && isWave q, isSquare q, isWave (c1, c2, 0))
  >   , ((f >= 0 && f < 1) || x - x /= x - x, exp x >= 0 || x /= x, nanoseconds (x * 1[s]) >= 0 || x /= x)
  >   , floorFloat x <= x && ceilingFloat x >= x || x /= x
  >   )
  > FROB
  $ python3 edges.py one in > edges.csv
  $ judge one
  double: 975 rows, 0 broken
  float: 975 rows, 0 broken

Functions of two numbers:

  $ cat > two.frob << 'FROB'
  > import Control
  > import Geometry
  > finite :: Float -> Bool
  > finite x = x - x == x - x
  > isAngle :: Angle -> Bool
  > isAngle y = y > -pi && y <= pi
  > gains :: Float -> Pid[1, 1]
  > gains x = Pid { kp = 2, ki = 0.5[1/s], kd = 0.1[s], largest = abs x }
  > main :: SF (Float, Float) ((Bool, Bool, Bool, Bool), (Bool, Bool, Bool, Bool), (Bool, Bool))
  > main = proc (x, y) -> let
  >     w = abs x
  >     l = limit w y
  >     low = min x y
  >     high = max x y
  >     d = deadband w y
  >     p = pid (gains 3) y
  >     v = Vec2 { x = x, y = y }
  >     m = mod (round x) (round y)
  >   in
  >   ( ( not (finite (x - y)) || isAngle (angleDiff x y)
  >     , l >= -w && l <= w, clamp low high x == x && clamp low high y == y && clamp low high 0.5 >= low && clamp low high 0.5 <= high
  >     , if w - w /= w - w then True else (if abs y <= w then d == 0 else abs d <= abs y && d * y >= 0)
  >     )
  >   , ( atan2 x y >= -pi && atan2 x y <= pi, direction v >= -pi && direction v <= pi
  >     , hypot x y >= abs x && hypot x y >= abs y, norm v >= 0 && distance v zeroVec >= 0
  >     )
  >   , (abs p <= 3 || not (p == p), if round y == 0 then m == 0 else if round y > 0 then m >= 0 && m < round y else m <= 0 && m > round y)
  >   )
  > FROB
  $ python3 edges.py two in.1 in.2 > edges.csv
  $ judge two
  double: 889 rows, 0 broken
  float: 889 rows, 0 broken

Random numbers never reach 1, whatever the seed:

  $ cat > chance.frob << 'FROB'
  > import Sources
  > main :: SF Int (Bool, Bool)
  > main = proc n -> let
  >     u = uniform n
  >     v = uniformNoise 5 n
  >     z = normal u v
  >   in (u >= 0 && u < 1 && v >= 0 && v < 1, z - z == 0)
  > FROB
  $ python3 -c '
  > import random
  > random.seed(2)
  > print("time,in")
  > for k, n in enumerate([0, -1, 2**31 - 1, -2**31] + [random.randrange(-2**31, 2**31) for _ in range(2000)]): print(k, n, sep=",")' > edges.csv
  $ judge chance
  double: 2004 rows, 0 broken
  float: 2004 rows, 0 broken
