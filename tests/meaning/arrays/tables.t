A table is an array that is known to the compiler. Any index can be read; an
index outside the table yields the default.

  $ cat > speeds.frob <<'FROB'
  > data Gear = Gear { top :: Velocity, ratio :: Float, name :: Name }
  > data Name = Low | Middle | High
  > 
  > gears :: Array 3 Gear
  > gears =
  >     [ Gear { top = 0.1[m/s], ratio = 4, name = Low }
  >     , Gear { top = 0.4[m/s], ratio = 2, name = Middle }
  >     , Gear { top = 1[m/s], ratio = 1, name = High }
  >     ]
  > 
  > squares :: Array 5 Int
  > squares = generate (\i -> i * i)
  > 
  > -- | The first gear that is fast enough, or the last.
  > gearFor :: Velocity -> Gear
  > gearFor v = foldl better (gears ! 2) gears where
  >     better best gear = if gear.top >= v && gear.top < best.top then gear else best
  > 
  > main :: SF (Int, Velocity) (Gear, Int, Name)
  > main = proc (i, v) -> (at i (gears ! 0) gears, at i (-1) squares, (gearFor v).name)
  > FROB
  $ cat > in.csv <<'CSV'
  > time,in.1,in.2
  > 0,0,0
  > 1,1,0.2
  > 2,2,0.4
  > 3,3,0.5
  > 4,4,7
  > 5,5,nan
  > 6,-1,-inf
  > CSV
  $ frobc trace speeds.frob --input in.csv | tee c.csv
  time,out.1.top,out.1.ratio,out.1.name,out.2,out.3
  0.000000000,0.10000000000000001,4,Low,0,Low
  1.000000000,0.40000000000000002,2,Middle,1,Middle
  2.000000000,1,1,High,4,Middle
  3.000000000,0.10000000000000001,4,Low,9,High
  4.000000000,0.10000000000000001,4,Low,16,High
  5.000000000,0.10000000000000001,4,Low,-1,High
  6.000000000,0.10000000000000001,4,Low,-1,Low
  $ frobc trace speeds.frob --input in.csv --engine interp | cmp - c.csv

A table of numbers is constant data in C; no step computes it again:

  $ cat > curve.frob <<'FROB'
  > main :: SF Int Float
  > main = proc i -> at i 0 [0.5, 0.25, 0.125]
  > FROB
  $ frobc compile curve.frob
  $ grep 'static const struct' curve.c
      static const struct curve_float_3 t1 = {{0.5, 0.25, 0.125}}; /* line 2 */
