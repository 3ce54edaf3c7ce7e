How long a mode waits is kept as whole nanoseconds if all that enter it give literals: then
nothing is left to convert at each step. What else is computed of such a parameter alone
is computed by the compiler too.

  $ cat > errand.frob <<'EOF'
  > main :: SF Float Float
  > main = runTask (forever errand) >>> arr (either id id)
  > 
  > errand :: Task Float Float ()
  > errand = do
  >     x <- snapT
  >     if x > 1 then turn 30[deg] else turn (-90[deg])
  >     y <- snapT
  >     if y > 1 then sleepT 1[s] 0 else sleepT 2.5[s] 0
  > 
  > turn :: Angle -> Task Float Float ()
  > turn a = mkTask (proc x -> (x * sin a, when (delay 0 x > 5)))
  > EOF
  $ frobc compile errand.frob --lint
  $ grep -E 'parameter at|_ns = INT|_ns <=|sin_a' errand.h errand.c
  errand.h:            double sin_a;                           /* parameter at errand.frob:12 */
  errand.h:            int64_t q_ns;                             /* parameter at errand.frob:9 */
  errand.c:        double sin_a, double x, double *out_1, bool *out_2, bool *out_3)
  errand.c:        *out_1 = x * sin_a;
  errand.c:    const bool t1 = q_ns <= self->time;                     /* Prelude.frob:356 */
  errand.c:                self->modes.turn.sin_a = 0.5;
  errand.c:                self->modes.turn.sin_a = -1.0;
  errand.c:            errand_forever_turn_step(&self->modes.turn.state, self->modes.turn.sin_a, x,
  errand.c:                self->modes.sleepT.q_ns = INT64_C(1000000000);
  errand.c:                self->modes.sleepT.q_ns = INT64_C(2500000000);
  errand.c:                self->modes.turn.sin_a = 0.5;
  errand.c:                self->modes.turn.sin_a = -1.0;
