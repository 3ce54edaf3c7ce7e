Numbers are total: every division, conversion and power has a value.

  $ . ./trace.sh

On Int, `+ - *` wrap around; `div` and `mod` round towards minus infinity; division
by 0 yields 0, and the least Int divided by -1 is itself. The expected values,
computed with doubles:

  $ cat > whole.frob << FROB
  > main :: SF (Int, Int) (Int, Int, Int, Int)
  > main = proc (a, b) -> (a + b, a - b, a \`div\` b, a \`mod\` b)
  > FROB
  $ cat > pairs << PAIRS
  > 7,2
  > -7,2
  > 7,-2
  > -7,-2
  > 6,3
  > -6,3
  > 0,5
  > 5,0
  > -5,0
  > 0,0
  > 2147483647,1
  > 2147483647,-1
  > -2147483648,1
  > -2147483648,-1
  > -2147483648,2147483647
  > -2147483648,-2147483648
  > 2147483647,-2147483648
  > PAIRS
  $ cat > expect.awk << 'AWK'
  > function wrap(x) { return x > 2147483647 ? x - 4294967296 : x < -2147483648 ? x + 4294967296 : x }
  > function floor(x) { return int(x) - (int(x) > x) }
  > {
  >   q = $2 == 0 ? 0 : floor($1 / $2)
  >   r = $2 == 0 ? 0 : $1 - q * $2
  >   printf "%.0f,%.0f,%.0f,%.0f\n", wrap($1 + $2), wrap($1 - $2), wrap(q), r
  > }
  > AWK
  $ rows in.1,in.2 < pairs | trace whole | cells > found
  $ awk -F, -f expect.awk pairs | diff - found
  $ sed -n '8p;14p' found
  5,5,0,0
  2147483647,-2147483647,-2147483648,0

Products, absolute values, signs:

  $ cat > products.frob << FROB
  > main :: SF Int (Int, Int, Int, Int)
  > main = proc a -> (a * 65537, abs a, negate a, signum a)
  > FROB
  $ printf '%s\n' 65536 -3 0 -2147483648 2147483647 | rows in | trace products | cells
  65536,65536,-65536,1
  -196611,3,3,-1
  0,0,0,0
  -2147483648,-2147483648,-2147483648,-1
  2147418111,2147483647,-2147483647,1

Bit operations are on 32-bit numbers, and shifts are defined for every amount. The shell computes
with 64 bits, so its results are wrapped.

  $ cat > bits.frob << FROB
  > main :: SF (Int, Int) ((Int, Int, Int, Int), Int, Int)
  > main = proc (a, b) -> ((a .&. b, a .|. b, a \`xor\` b, complement a), a \`shiftL\` b, a \`shiftR\` b)
  > FROB
  $ cat > pairs << PAIRS
  > 12,10
  > -1,255
  > 1,31
  > -2147483648,31
  > -5,1
  > 77,32
  > -77,32
  > -77,1000
  > 77,-1
  > -77,-3
  > 77,-32
  > -77,-40
  > 2147483647,2147483647
  > -2147483648,-2147483648
  > 1431655765,-1431655766
  > PAIRS
  $ cat > expect.sh << 'SHELL'
  > wrap() { echo $((($1 << 32) >> 32)); }
  > left() { wrap $(($2 > 31 ? 0 : $1 << $2)); }
  > right() { wrap $(($1 >> ($2 > 31 ? 31 : $2))); }
  > while IFS=, read -r a b; do
  >   if [ $b -lt 0 ]; then l=$(right $a $((-b))) r=$(left $a $((-b))); else l=$(left $a $b) r=$(right $a $b); fi
  >   echo "$((a & b)),$((a | b)),$((a ^ b)),$((~a)),$l,$r"
  > done
  > SHELL
  $ rows in.1,in.2 < pairs | trace bits | cells > found
  $ sh expect.sh < pairs | diff - found
  $ sed -n '3p;5p;10p' found
  1,31,30,-2,-2147483648,0
  1,-5,-6,4,-10,-3
  -79,-1,78,76,-10,-616

Operations on constants, in Haskell's argument order:

  $ cat > known.frob << FROB
  > main :: SF () (Int, Int, Int, Bool, Int, Array 0x2 Int)
  > main = constant (1 .|. 6 \`xor\` 5 .&. 3 \`shiftL\` 1, 1 \`shiftL\` 40, (-77) \`shiftR\` (-3), 5 .&. 4 == 4, 3 + 1 .&. 2, [0x1F .|. 0b1010_0000, 0o17 ^ 0x2])
  > FROB
  $ printf 'time\n0\n' | trace known | cells
  3,0,-616,true,3,191,225

`round` rounds halves away from zero; all conversions saturate, and convert NaN
to 0:

  $ cat > conversions.frob << FROB
  > main :: SF Float (Int, Int, Int, Int)
  > main = proc x -> (round x, floor x, ceiling x, truncate x)
  > FROB
  $ rows in << 'CELLS' | trace conversions | cells
  > 2.5
  > -2.5
  > 3.5
  > 0.49999999999999994
  > -0.5
  > 0.3
  > -0.3
  > 2147483646.5
  > 2147483647.5
  > -2147483648.5
  > -2147483649
  > 1e300
  > inf
  > -inf
  > nan
  > CELLS
  3,2,3,2
  -3,-3,-2,-2
  4,3,4,3
  0,0,1,0
  -1,-1,0,0
  0,0,1,0
  0,-1,0,0
  2147483647,2147483646,2147483647,2147483646
  2147483647,2147483647,2147483647,2147483647
  -2147483648,-2147483648,-2147483648,-2147483648
  -2147483648,-2147483648,-2147483648,-2147483648
  2147483647,2147483647,2147483647,2147483647
  2147483647,2147483647,2147483647,2147483647
  -2147483648,-2147483648,-2147483648,-2147483648
  0,0,0,0

`floorFloat` and `ceilingFloat` return Floats, with the same unit and of any size; 1/x distinguishes
0 from -0:

  $ cat > whole.frob << FROB
  > main :: SF Float (Float, Float, Float)
  > main = proc x -> (floorFloat (x * 1[m]) / 1[m], ceilingFloat (x * 1[m]) / 1[m], 1 / ceilingFloat x)
  > FROB
  $ rows in << 'CELLS' | trace whole | cells
  > 2.5
  > -2.5
  > -0.3
  > 7
  > 4503599627370495.5
  > -2147483648.5
  > 1e300
  > -inf
  > nan
  > CELLS
  2,3,0.33333333333333331
  -3,-2,-0.5
  -1,-0,-inf
  7,7,0.14285714285714285
  4503599627370495,4503599627370496,2.2204460492503131e-16
  -2147483649,-2147483648,-4.6566128730773926e-10
  1.0000000000000001e+300,1.0000000000000001e+300,1e-300
  -inf,-inf,-0
  nan,nan,nan

`min` and `max` of Floats are NaN if either is, else the first of two equal ones; 1/x distinguishes
0 from -0. `signum` preserves NaN.

  $ cat > extremes.frob << FROB
  > main :: SF (Float, Float) (Float, Float, Float, Float)
  > main = proc (x, y) -> (min x y, max x y, 1 / min x y, signum x)
  > FROB
  $ rows in.1,in.2 << 'CELLS' | trace extremes | cells
  > 1,2
  > 2,1
  > nan,1
  > 1,nan
  > inf,nan
  > -inf,inf
  > 0,-0
  > -0,0
  > CELLS
  1,2,1,1
  1,2,1,1
  nan,nan,nan,nan
  nan,nan,nan,1
  nan,nan,nan,1
  -inf,inf,-0,-1
  0,0,inf,0
  -0,-0,-inf,-0

They work on every ordered type:

  $ cat > orders.frob << FROB
  > data Side = LeftSide | At Int | RightSide
  > main :: SF (Int, Side, Side) ((Int, Bool), Side, Side, Bool, Bool)
  > main = proc (n, a, b) -> (min (n, True) (2, False), min a b, max a b, a == b, a < b)
  > FROB
  $ rows in.1,in.2,in.3 << 'CELLS' | trace orders | cells
  > 1,LeftSide,RightSide
  > 2,At 3,At 4
  > 3,At 3,LeftSide
  > 4,RightSide,RightSide
  > CELLS
  1,true,LeftSide,RightSide,false,true
  2,false,At 3,At 4,false,true
  2,false,LeftSide,At 3,false,false
  2,false,RightSide,RightSide,true,false

Comparisons with NaN are false, except `/=`:

  $ cat > comparisons.frob << FROB
  > main :: SF (Float, Float) (Bool, Bool, Bool, Bool, Bool, Bool)
  > main = proc (x, y) -> (x == y, x /= y, x < y, x <= y, x > y, x >= y)
  > FROB
  $ printf '%s\n' nan,1 nan,nan 0,-0 1,2 | rows in.1,in.2 | trace comparisons | cells
  false,true,false,false,false,false
  false,true,false,false,false,false
  true,false,false,true,false,true
  false,true,true,true,false,false

Powers with a literal exponent are products, and exact if these are; on Int they
wrap. `**` is `pow` as in C99, Annex F.

  $ cat > powers.frob << FROB
  > main :: SF (Int, Float) (Int, Int, Float, Float, Float, Float)
  > main = proc (n, x) -> (n ^ 0, n ^ 5, x ^ 0, x ^ 3, x ^ (-2), x ** 0.5)
  > FROB
  $ printf '%s\n' 3,3 -2,-2 0,0 65536,nan 100,inf | rows in.1,in.2 | trace powers | sed 1d | cut -d, -f2-5,7
  NaN: out.6, first at 1.000 s; to find its origin, run `frobc view --why-nan`
  1,243,1,27,1.7320508075688772
  1,-32,1,-8,nan
  1,0,1,0,0
  1,0,1,nan,nan
  1,1410065408,1,inf,inf
  $ printf '%s\n' 2,2 2,-4 2,0 2,inf | rows in.1,in.2 | trace powers | cut -d, -f6
  NaN: out.6, first at 1.000 s; to find its origin, run `frobc view --why-nan`
  out.5
  0.25
  0.0625
  inf
  0

Float follows IEEE:

  $ cat > ieee.frob << FROB
  > main :: SF (Float, Float) (Float, Float, Float, Float)
  > main = proc (x, y) -> (x / y, sqrt x, log x, hypot x y)
  > FROB
  $ printf '%s\n' 1,0 -1,0 0,0 0,-2 inf,nan | rows in.1,in.2 | trace ieee | cells
  NaN: out.1, first at 2.000 s; to find its origin, run `frobc view --why-nan`
  NaN: out.2, first at 1.000 s
  NaN: out.3, first at 1.000 s
  inf,1,0,1
  -inf,nan,nan,1
  nan,0,-inf,0
  -0,0,-inf,2
  nan,inf,inf,inf
  $ echo 3e200,4e200 | rows in.1,in.2 | trace ieee | cells | tr , '\n' | xargs printf '%.6g '
  0.75 1.73205e+100 461.616 5e+200 
