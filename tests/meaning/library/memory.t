Functions of the module Control that store values of every type, in both engines.

  $ . ./trace.sh
  $ cat > previous.frob << 'FROB'
  > import Control
  > data Side = LeftSide | RightSide Int
  > main :: SF (Int, Bool) ((Int, Side, Array 2 Int, Maybe Bool), (Int, Int, Int))
  > main = proc (n, b) ->
  >     ( (previous n, previous (if b then RightSide n else LeftSide), previous [n, -n], previous (Just b))
  >     , (stateFrom id max n, stateFrom (const 0) (\count _ -> count + 1) b, stateFrom (\x -> 2 * x) (+) n) )
  > FROB
  $ printf '%s\n' 3,true 5,false 4,true 9,true | rows in.1,in.2 | trace previous | cells
  3,RightSide 3,3,-3,Just true,3,0,6
  3,RightSide 3,3,-3,Just true,5,1,11
  5,LeftSide,5,-5,Just false,5,2,15
  4,RightSide 4,4,-4,Just true,9,3,24

`delayBy` with steps that jitter, steps of length 0, and gaps; for numbers, and for pairs in an array.
A list of all inputs and their times is the model. It stores all inputs if there are at most 63 in the
time; otherwise the output may be up to 1/63 of the time older:

  $ cat > delayed.frob << 'FROB'
  > import Control
  > type Numbers = (Int, Int, Int, Int, Int)
  > main :: SF Int (Numbers, (Array 1 (Bool, Int), Int, Int))
  > main = proc n ->
  >     ( (delayBy 0.5[s] n, delayBy 0[s] n, delayBy 0.02[s] n, delayBy 7[s] n, delayBy 2[s] n)
  >     , (delayBy 0.5[s] [(n > 3, n)], delayBy nothing n, delayed (-1) n) )
  > delayed :: Float -> SF Int Int
  > delayed q = delayBy (q * 1[s])
  > nothing :: Time
  > nothing = 0[s] / 0
  > FROB
  $ cat > delayed.py << 'END'
  > import csv, random, sys
  > if len(sys.argv) == 1:
  >     random.seed(2)
  >     print("time,in")
  >     t = 0
  >     for n in range(900):
  >         print(f"{t / 1e9:.9f},{n}")
  >         t += 0 if n % 40 == 7 else 4 * 10**9 if n % 300 == 150 else 20 * 10**6 if n < 100 else random.randint(10**7, 3 * 10**7)
  >     sys.exit()
  > given = [(round(float(r[0]) * 1e9), int(r[1])) for r in csv.reader(open(sys.argv[1])) if r[0] != "time"]
  > def at(k, q):
  >     """The newest input that is at least as old as q; the first one if there is none."""
  >     old = [n for t, n in given[: k + 1] if given[k][0] - t >= q]
  >     return old[-1] if old else given[0][1]
  > def is_near(k, q, n):
  >     """At most q / 63 and a step older than that."""
  >     exact = given[at(k, q)][0]
  >     return exact - q // 63 - 3 * 10**7 <= given[n][0] <= exact
  > exact, near, late = 0, 0, 0
  > for k, row in enumerate(list(csv.reader(open(sys.argv[2])))[1:]):
  >     cells = row[1:]
  >     for column, q in (0, 500), (1, 0), (2, 20), (7 + 1, 0):
  >         exact += int(cells[column]) != at(k, q * 10**6)
  >     exact += cells[5] != str(at(k, 5 * 10**8) > 3).lower() or int(cells[6]) != at(k, 5 * 10**8)
  >     for column, q in (3, 7 * 10**9), (4, 2 * 10**9):
  >         near += not is_near(k, q, int(cells[column]))
  >     late += cells[7] != "0"
  > print(k + 1, "instants,", exact, "differ,", near, "outside the bound,", late, "after the time NaN")
  > END
  $ python3 delayed.py > delayed.csv
  $ trace delayed < delayed.csv > delayed.out
  $ python3 delayed.py delayed.csv delayed.out
  900 instants, 0 differ, 0 outside the bound, 0 after the time NaN
  $ frobc trace delayed.frob --real float --input delayed.csv --output single.csv
  $ python3 delayed.py delayed.csv single.csv
  900 instants, 0 differ, 0 outside the bound, 0 after the time NaN

Filters continue after a NaN, and `holdFinite` replaces it:

  $ cat > nan.frob << 'FROB'
  > import Control
  > main :: SF Float (Float, Float, Float, Float, Float, Float)
  > main = proc x ->
  >     ( lowPass 1[s] x, rateLimit 1[1/s] x, movingAverage [1, 1] x, holdFinite 7 x
  >     , integral (holdFinite 0 x) / 1[s], finiteSlope x * 1[s] )
  > FROB
  $ printf '%s\n' nan 1 2 nan 4 inf 8 | rows in | trace nan 2> /dev/null | cells
  nan,nan,nan,7,0,nan
  1,1,1,1,0,0
  1.5,2,1.5,2,1,1
  nan,nan,nan,2,3,nan
  3.1666666666666665,3,3,4,5,1
  inf,4,inf,4,9,inf
  6.3888888888888893,5,6,8,13,2
  $ cat > pid.frob << 'FROB'
  > import Control
  > main :: SF Float (Float, Float)
  > main = proc e -> (pid gains e, pid (gains { kd = 0 }) e) where
  >     gains = Pid { kp = 1, ki = 1[1/s], kd = 1[s], largest = 100 }
  > FROB
  $ printf '%s\n' 1 nan 1 1 | rows in | trace pid 2> /dev/null | cells
  1,1
  nan,nan
  2,2
  3,3
