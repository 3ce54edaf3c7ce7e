Signal functions are values: passed, returned, stored in data, chosen, partially applied. Every
trace is run compiled and interpreted, and was computed by hand.

  $ trace() {
  >   cat > in.csv
  >   frobc trace --lint --engine interp "$1.frob" --input in.csv --output interpreted.csv
  >   frobc trace --lint "$1.frob" --input in.csv | tee compiled.csv
  >   cmp compiled.csv interpreted.csv
  > }
  $ counted() { printf 'time,in\n0,1\n1,2\n2,3\n' | trace "$1"; }

  $ counted passed_and_returned
  time,out.1,out.2
  0.000000000,0,0
  1.000000000,0,1
  2.000000000,1,2

  $ counted in_tuples_and_records
  time,out.1,out.2
  0.000000000,2,7
  1.000000000,3,1
  2.000000000,4,2

  $ counted partially_applied
  time,out.1,out.2
  0.000000000,0.5,0.25
  1.000000000,2,1.5
  2.000000000,3.5,2.75

  $ counted chosen_by_a_parameter
  time,out.1,out.2
  0.000000000,2,1
  1.000000000,6,2
  2.000000000,10,3

  $ printf 'time,in.1,in.2\n0,1,true\n1,2,false\n2,3,true\n' | trace functions_from_signals
  time,out.1,out.2
  0.000000000,23,Just 205
  1.000000000,26,Nothing
  2.000000000,29,Just 215

  $ printf 'time,in.1,in.2\n0,1,5\n1,2,6\n2,3,7\n' | trace combinators
  time,out.1.1,out.1.2,out.2.1,out.2.2,out.3.1,out.3.2,out.4,out.5
  0.000000000,0,5,1,0,0,-5,0,1
  1.000000000,1,6,2,5,1,-6,1,2
  2.000000000,2,7,3,6,2,-7,2,6

  $ printf 'time\n0\n0.5\n1\n' | trace loop_closed_by_integral
  time,out
  0.000000000,0
  0.500000000,0.5
  1.000000000,0.75

A signal function that is doubled twenty times compiles quickly, to C that does
not grow with it. The response to an impulse is the binomial coefficients over
2^20, modulo 2^32.

  $ timeout 20 frobc compile --lint doubling.frob && test $(wc -l < doubling.c) -lt 300
  $ printf 'time,in\n0,1\n1,0\n2,0\n' > in.csv
  $ timeout 20 frobc trace doubling.frob --input in.csv
  time,out
  0.000000000,1
  1.000000000,1048576
  2.000000000,-524288
  $ awk 'BEGIN { n = 2 ^ 20; print n, (n * (n - 1) / 2) % 2 ^ 32 - 2 ^ 32 }'
  1048576 -524288
