The values with which a mode is entered are stored unchanged; values computed from these alone are
computed when the mode starts, not at each step.

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
  $ grep -E 'parameter at|nanoseconds_q|sin_a' errand.h errand.c
  errand.h:            double sin_a;  /* computed by reset at errand.frob:12 */
  errand.h:            double nanoseconds_q; /* computed by reset at Prelude.frob:358 */
  errand.c:    self->modes.turn.sin_a = frob_sin(a);
  errand.c:        *out_1 = x * self->modes.turn.sin_a;
  errand.c:    self->modes.sleepT.nanoseconds_q = frob_nanoseconds(q);
  errand.c:    const bool t1 = self->modes.sleepT.nanoseconds_q
