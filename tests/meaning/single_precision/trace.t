The trace is the same from the compiled C and from the interpreter, and its numbers have the fewest
digits that read back as the same float.

  $ cat > numbers.frob <<EOF
  > data Side = LeftSide | At Float
  > 
  > main :: SF (Float, Side) (Float, Side, Event Float, Float, Float, Float, Int)
  > main = proc (x, side) -> (x * 1.1, twice side, when3 x, sin x, x ** 0.3, integral x / 1[s], round (x * 1.0e10)) where
  >     twice s = case s of
  >         LeftSide -> At x
  >         At y -> At (2 * y)
  >     when3 y = if y > 3 then Event (y / 3) else NoEvent
  > EOF
  $ cat > in.csv <<EOF
  > time,in.1,in.2
  > 0,0.1,LeftSide
  > 0.1,3.3333333333,At (-0.7)
  > 0.2,16777217,At 1e30
  > 0.3,1e-40,At 3e38
  > 1000000.123456789,nan,At (-inf)
  > EOF
  $ frobc trace numbers.frob --real float --input in.csv
  time,out.1,out.2,out.3,out.4,out.5,out.6,out.7
  0.000000000,0.11000001,At 0.1,,0.09983342,0.5011872,0,1000000000
  0.100000000,3.6666667,At (-1.4),1.111111,-0.19056788,1.4350387,0.010000001,2147483647
  0.200000000,18454938,At 2e+30,5592405.5,-0.77956367,147.03342,0.34333333,2147483647
  0.300000000,1.09999e-40,At inf,,1e-40,9.999973e-13,1677722,0
  1000000.123456789,nan,At (-inf),,nan,nan,1677722,0
  $ frobc trace numbers.frob --real float --input in.csv > c.csv
  $ frobc trace numbers.frob --real float --input in.csv --engine interp | cmp - c.csv

After half a day steps still have their exact length, and no tick of a counter is lost: a local time
is stored in nanoseconds, and only its seconds are a float.

  $ cat > late.frob <<EOF
  > import Control
  > 
  > main :: SF Bool (Time, Time, Event (), Bool, Float)
  > main = proc b -> (time (), stepTime (), every 0.7[s] (), debounce 0.3[s] b, lowPass 0.1[s] (if b then 1 else 0))
  > EOF
  $ cat > late.csv <<EOF
  > time,in
  > 0,false
  > 50000.1,true
  > 50000.2,true
  > 50000.3,true
  > 50000.4,true
  > 50000.5,true
  > EOF
  $ frobc trace late.frob --real float --input late.csv
  time,out.1,out.2,out.3,out.4,out.5
  0.000000000,0,0,,false,0
  50000.100000000,50000.1,50000.1,(),false,0.999998
  50000.200000000,50000.203,0.1,,false,0.999999
  50000.300000000,50000.297,0.1,(),false,0.9999995
  50000.400000000,50000.4,0.1,,true,0.99999976
  50000.500000000,50000.5,0.1,,true,0.9999999
  $ frobc trace late.frob --real float --input late.csv > c.csv
  $ frobc trace late.frob --real float --input late.csv --engine interp | cmp - c.csv
