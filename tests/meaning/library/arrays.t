The module Arrays, in both engines and in both precisions of Float, compared with Python.

  $ . ./trace.sh
  $ engines () {
  >   for real in double float; do
  >     for engine in c interp; do
  >       frobc trace $1.frob --real $real --engine $engine --input $1.csv --output $1.$real.$engine 2>&1 | grep -v '^NaN: '
  >     done
  >     cmp $1.$real.c $1.$real.interp
  >   done
  > }

Sorting and searching, with equal elements, NaN and infinities:

  $ cat > arrays.frob << 'FROB'
  > import Arrays
  > main :: SF (Int, Array 7 Float) (Array 7 Float, Array 7 Int, Array 7 Float, Array 7 Float, (Float, Maybe Int, Maybe Int, Int))
  > main = proc (k, xs) ->
  >     ( sort xs, map snd (sortBy key (imap (\i x -> (x, i)) xs)), rotateLeft k xs, reverse xs
  >     , (last xs, indexOf 2 xs, indexWhere (> 2) xs, countWhere (> 2) xs) )
  > key :: (Float, Int) -> Float
  > key (x, _) = abs x
  > FROB
  $ cat > model.py << 'END'
  > import csv, math, random, sys
  > if len(sys.argv) == 1:
  >     random.seed(3)
  >     print("time,in.1," + ",".join(f"in.2[{i}]" for i in range(7)))
  >     for t in range(200):
  >         xs = [random.choice(["nan", "inf", "-inf", "-1", "0", "2", "2", "3.5"]) for _ in range(7)]
  >         print(f"{t},{random.randint(-20, 20)}," + ",".join(xs))
  >     sys.exit()
  > def number(x):
  >     return (1, 0) if math.isnan(x) else (0, x)
  > def first(xs, holds):
  >     return next((f"Just {i}" for i, x in enumerate(xs) if holds(x)), "Nothing")
  > wrong = 0
  > for given, found in zip(csv.reader(open(sys.argv[1])), csv.reader(open(sys.argv[2]))):
  >     if given[0] == "time":
  >         continue
  >     k, xs = int(given[1]), [float(x) for x in given[2:]]
  >     turned = [xs[(i + k) % 7] for i in range(7)]
  >     model = sorted(xs, key=number) + sorted(range(7), key=lambda i: number(abs(xs[i]))) + turned + xs[::-1]
  >     model += [xs[-1], first(xs, lambda x: x == 2), first(xs, lambda x: x > 2), sum(x > 2 for x in xs)]
  >     for a, b in zip(model, found[1:]):
  >         same = a == b if isinstance(a, str) else float(b) == a or (a != a and b == "nan")
  >         wrong += not same
  > print(len(found) - 1, "cells in a row,", wrong, "differ")
  > END
  $ python3 model.py > arrays.csv
  $ engines arrays
  $ for real in double float; do python3 model.py arrays.csv arrays.$real.c; done
  32 cells in a row, 0 differ
  32 cells in a row, 0 differ

`sortWith` never loses an element, even if the function contradicts itself:

  $ cat > odd.frob << 'FROB'
  > import Arrays
  > main :: SF (Array 5 Int) (Array 5 Int, Array 5 Int, Array 5 Int)
  > main = proc xs -> (sortWith (>) xs, sortWith (\_ _ -> True) xs, sortWith (\_ _ -> False) xs)
  > FROB
  $ printf '%s\n' 3,1,2,3,0 | rows 'in[0],in[1],in[2],in[3],in[4]' | trace odd | cells
  3,3,2,1,0,0,3,2,1,3,3,1,2,3,0

A size is a number in an expression:

  $ cat > sizes.frob << 'FROB'
  > type N = 5
  > type M = N
  > main :: SF (Array N Float) (Float, Int, Float)
  > main = proc xs -> (xs ! (N - 1), 2 * M, xs ! 0 / N)
  > FROB
  $ printf '%s\n' 3,1,2,3,0.5 | rows 'in[0],in[1],in[2],in[3],in[4]' | trace sizes | cells
  0.5,10,0.59999999999999998
