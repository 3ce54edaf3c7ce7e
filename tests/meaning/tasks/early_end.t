When a mode ends, its outputs and its state are dropped, because the next mode takes its step in the
same instant. So its transitions come first, and the rest of its step runs only if none of them
occurs.

  $ . ./trace.sh
  $ cat > early.frob <<'EOF'
  > import Control
  > 
  > data Sensed = Sensed { x, ahead :: Distance }
  > 
  > main :: SF Sensed Float
  > main = proc i -> either id id (runTask (forever errand) i)
  > 
  > errand :: Task Sensed Float ()
  > errand = do
  >     go `abortWhen` near 1[m]
  >     go `abortWhen` near 2[m]
  >     sleepT 1[s] 0
  > 
  > go :: Task Sensed Float ()
  > go = mkTask (work &&& never)
  > 
  > near :: Distance -> SF Sensed (Event ())
  > near d = proc i -> when (abs (i.x - d) < 0.1[m])
  > 
  > work :: SF Sensed Float
  > work = proc i -> s * 1[1/m] + sin (delay 0 (i.ahead * 1[1/m])) + exp (integral i.x * 1[1/(m s)]) where
  >     s = lowPass 1[s] i.ahead + lowPass 2[s] i.x
  > EOF
  $ frobc compile early.frob
  $ sed -n '/^static.*abortWhen_step(/,/^}/p' early.c | sed -n '/^{/,$p'
  {
      const bool t1 = fabs(x_x - 1.0) < 0.1;                  /* line 18 */
      *out_2 = t1;
      if (!t1) {                                              /* line 10 */
          const double y = early_go_step(&self->modes.abortWhen.go, dt, x_x, x_ahead); /* line 15 */
          *out_1 = y;                                         /* Prelude.frob:690 */
      }
  }
  $ printf '%s\n' 0,1 0.5,2 1,3 1.5,4 2,5 2,6 2,7 1,8 0,9 | rows in.x,in.ahead | trace early
  time,out
  0.000000000,2
  0.500000000,3.2748043181412299
  1.000000000,5
  1.500000000,6.2231746120933291
  2.000000000,0
  2.500000000,0
  3.000000000,10
  3.500000000,10
  4.000000000,11.771412850656844

This is done even if little is skipped, because C compilers then see which of two modes' outputs
counts. But if the output of a mode still counts at the instant when it ends, there is no such
branch.

  $ cat > plain.frob <<'EOF'
  > main :: SF Float Float
  > main = proc x -> either id id (runTask (forever legs) x)
  > 
  > legs :: Task Float Float ()
  > legs = do
  >     mkTask (proc x -> (x + 1, when (x > 3)))
  >     sleepT 1[s] 0
  > EOF
  $ frobc compile plain.frob
  $ grep -c 'if (!' plain.c
  2
  $ cat > delayed.frob <<'EOF'
  > main :: SF Float Float
  > main = first `dSwitch` const (arr negate)
  > 
  > first :: SF Float (Float, Event ())
  > first = proc x -> (sin (delay 0 x) + exp x * cos x, when (x > 3))
  > EOF
  $ frobc compile delayed.frob
  $ grep -c 'if (!t' delayed.c
  0
  [1]
  $ printf '%s\n' 1 2 4 5 | rows in | trace delayed
  time,out
  0.000000000,1.4686939399158851
  0.500000000,-2.2334613358314623
  1.000000000,-34.77843505329345
  1.500000000,-5
