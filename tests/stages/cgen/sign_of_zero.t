`0 - abs x` is 0 for x = 0, not -0, whatever constants the C compiler folds.

  $ cat > zero.frob <<'FROB'
  > main :: SF Float (Float, Float, Float)
  > main = proc x -> (0 - abs x, 0 + (- abs x), (- abs x) + 0)
  > FROB
  $ printf 'time,in\n0,0\n1,-0.0\n2,3\n' > zero.csv
  $ CC=gcc frobc trace zero.frob --input zero.csv
  time,out.1,out.2,out.3
  0.000000000,0,0,0
  1.000000000,0,0,0
  2.000000000,-3,-3,-3
  $ CC=clang frobc trace zero.frob --input zero.csv | cksum > clang
  $ frobc trace zero.frob --input zero.csv --engine interp | cksum | cmp - clang

clang 13 to 15 treat `x > 0.0 ? -0.0 : x` like `>=`, so that a zero x gets the wrong sign. They
cannot do so if they do not see that the other zero is negative. Every choice between a number and a
zero, with any signs, is correct:

  $ python3 > choices.frob <<'PY'
  > choices, joined = [], []
  > for zero in "0", "-0.0":
  >     choices += [f"min x ({zero})", f"max x ({zero})", f"min ({zero}) x", f"max ({zero}) x", f"limit ({zero}) x"]
  >     choices += [f"clamp ({zero}) {other} x" for other in ("0", "(-0.0)", "1")]
  >     joined += [f"min (Just x) (Just ({zero}))", f"max (Just x) (Just ({zero}))", f"max (Just ({zero})) (Just x)"]
  >     for order in "<", "<=", ">", ">=", "==", "/=":
  >         for result in "0", "-0.0", "-x":
  >             choices += [f"if x {order} {zero} then {result} else x", f"if x {order} {zero} then x else {result}"]
  >             joined += [f"if x {order} {zero} then Just ({result}) else Just x"]
  > tail = [f"if {i} < b then {c} else x" for i, c in enumerate(choices[:8])]
  > print("import Control\nmain :: SF (Float, Float) (Array %d Float, Array %d (Maybe Float), Array %d Float)" % (len(choices), len(joined), len(tail)))
  > print("main = proc (x, b) -> ([%s], [%s], [%s])" % tuple(", ".join(list) for list in (choices, joined, tail)))
  > PY
  $ printf 'time,in.1,in.2\n0,0,0\n1,-0.0,-0.0\n2,3,5\n3,-3,2\n4,nan,0\n5,inf,nan\n6,-inf,9\n' > choices.csv
  $ for real in double float; do
  >   frobc trace --real $real choices.frob --input choices.csv --engine interp > interp
  >   for cc in gcc clang; do CC=$cc frobc trace --real $real choices.frob --input choices.csv | cmp - interp; done
  > done

The C contains no negative zero that a compiler could see, and none in a comparison:

  $ frobc compile choices.frob
  $ grep -c -e '-0\.0' choices.c
  0
  [1]
  $ grep -c 'frob_negative_zero()' choices.c | sed 's/[1-9][0-9]*/some/'
  some
