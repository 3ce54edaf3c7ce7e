What a condition decides of the state is written where that is asked: a Bool that is
known there, and something simpler where it is not.

  $ cat > settles.frob <<'END'
  > import Control
  > 
  > main :: SF Bool Bool
  > main = debounce 30[ms]
  > END
  $ frobc compile settles.frob --lint
  $ sed -n '/^void settles_step/,/^}/p' settles.c | sed -n '/settled/,$p' | sed "s, */\*.*,,"
          const bool settled = INT64_C(30000000) <= self->time;
          if (FROB_BRANCH(settled)) {
              self->before = x;
              self->waiting = false;
          } else {
              self->waiting = differs;
          }
      }
      out->value = self->before;
  }

What still reads the field comes before.

  $ cat > reads.frob <<'END'
  > main :: SF (Float, Bool) (Float, Bool)
  > main = proc (x, b) -> (best, was && b) where
  >     before = delay 0 best
  >     grows = x > before
  >     best = if grows then x else before
  >     was = delay False (b && not grows)
  > END
  $ frobc compile reads.frob --lint
  $ sed -n '/^void reads_step/,/^}/p' reads.c | sed -n '/grows/,$p' | sed "s, */\*.*,,"
      const bool grows = self->before < x;
      out->f2 = self->was && b;
      if (FROB_BRANCH(grows)) {
          self->before = x;
          self->was = false;
      } else {
          self->was = b;
      }
      out->f1 = self->before;
  }
  $ printf 'time,in.1,in.2\n0,1,true\n1,0,true\n2,4,true\n3,3,true\n4,2,false\n5,2,true\n6,2,true\n' > in.csv
  $ frobc trace reads.frob --input in.csv | tee c.csv
  time,out.1,out.2
  0.000000000,1,false
  1.000000000,1,false
  2.000000000,4,true
  3.000000000,4,false
  4.000000000,4,false
  5.000000000,4,false
  6.000000000,4,true
  $ frobc trace reads.frob --input in.csv --engine interp | cmp - c.csv
