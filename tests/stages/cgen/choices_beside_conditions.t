A choice of what the state keeps stands next to its condition, before results that do
not need it: with two ways to the choice C compilers would make these twice. (What
winds up decides about itself, and so is a branch.)

  $ cat > winds.frob <<'END'
  > import Control
  > 
  > main :: SF (Float, Float) (Float, Bool)
  > main = proc (e, k) -> (limit 1 u, windsUp) where
  >     u = 2 * e + integral counted
  >     windsUp = abs u > 1 && e * u > k
  >     counted = if windsUp then 0 else e / 1[s]
  > END
  $ frobc compile winds.frob --lint
  $ sed -n '/^void winds_step/,/^}/p' winds.c | sed -n '/windsUp =/,$p' | sed "s, */\*.*,,"
      const bool windsUp = fabs(u) > 1.0 && k < e * u;
      if (FROB_BRANCH(windsUp)) {
          self->counted_integral_input = 0.0;
      } else {
          self->counted_integral_input = e;
      }
      out->f1 = frob_at_least(frob_at_most(u, 1.0), -1.0);
      out->f2 = windsUp;
  }

Not before what still reads the field: the greatest one so far, as it was.

  $ cat > reads.frob <<'END'
  > main :: SF (Float, Float) (Float, Float)
  > main = proc (x, y) -> (y * before, best) where
  >     before = delay 0 best
  >     grows = x > before && x * before > y
  >     best = if grows then x + y else before
  > END
  $ frobc compile reads.frob --lint
  $ sed -n '/^void reads_step/,/^}/p' reads.c | sed -n '/grows/,$p' | sed "s, */\*.*,,"
      const bool grows = self->before < x && y < x * self->before;
      out->f1 = y * self->before;
      if (grows) {
          self->before = x + y;
      }
      out->f2 = self->before;
  }
  $ printf 'time,in.1,in.2\n0,1,-1\n1,3,-2\n2,4,100\n3,5,0\n' > in.csv
  $ frobc trace reads.frob --input in.csv | tee c.csv
  time,out.1,out.2
  0.000000000,-0,0
  1.000000000,-0,1
  2.000000000,100,1
  3.000000000,0,5
  $ frobc trace reads.frob --input in.csv --engine interp | cmp - c.csv
