A definition becomes at most one C function for each specialization, no matter how often it is used.
Different numbers and units do not require another specialization; different signal functions and
functions do.

  $ steps() { awk '/^\/\* .*, .*\.frob:[0-9]+ \*\/$/ { def = $2 " " $3; next }
  >   /^[a-z].*\(/ && def != "" && !/_reset\(/ { print def; def = "" }' "$1" | sed 's/:.*//' | sort | uniq -c; }
  $ cat > uses.frob <<'FROB'
  > import Control
  > 
  > smoothed :: SF Float Float -> SF Float Float
  > smoothed sf = proc x -> lowPass 0.3[s] (sf (rateLimit 1[1/s] (sf x)))
  > 
  > main :: SF (Float, Float[m], Bool) (Float, Float, Float[m], Bool)
  > main = proc (x, d, b) ->
  >     ( smoothed previous x + smoothed previous (x + 1)
  >     , smoothed (arr abs) x + smoothed (arr abs) (x + 1)
  >     , lowPass 1[s] (lowPass 2[s] d)
  >     , debounce 1[s] b || debounce 2[s] (debounce 3[s] b)
  >     )
  > FROB
  $ frobc compile uses.frob
  $ steps uses.c
        1 debounce, Control.frob
        1 lowPass, Control.frob
        1 main, uses.frob
        1 rateLimit, Control.frob
        2 smoothed, uses.frob

If a definition uses another one twice, and this is repeated over twenty levels, the program has a
million states of the first one, but one function for each level.

  $ { echo 'f0 :: SF Float Float'; echo 'f0 = proc x -> x + delay 0 x'
  >   for n in $(seq 1 20); do echo "f$n = f$((n - 1)) >>> f$((n - 1))"; done
  >   echo 'main = f20'; } > levels.frob
  $ frobc compile levels.frob
  $ grep -c '^[a-z].*_step(' levels.c
  10
  $ frobc report levels.frob | sed -n '2s/Prelude.*/Prelude/p'
    >>>                            8388608                 Prelude
  $ sed 's/^main = f20/main = f10/' levels.frob > ten.frob
  $ frobc compile ten.frob
  $ echo $(($(wc -l < levels.c) - $(wc -l < ten.c))) more lines for ten more levels
  90 more lines for ten more levels

A function that receives three or more members of the program's input unchanged, at each of its
calls, reads them through the pointer to the input.

  $ cat > pointer.frob <<'FROB'
  > main :: SF (Float, Float, Float, Bool) Float
  > main = proc (a, b, c, _) -> y where
  >     y = work 1 (a, b, c) + work 2 (a, b, c) + other (c, b, a) + other (a, b, c)
  > 
  > other :: SF (Float, Float, Float) Float
  > other = proc (p, q, r) -> s + s * s where
  >    s = delay 0 (sin p) + exp (delay 0 r) * p + q * r + exp p * exp q + delay 3 (q * q + r * r) * sin (cos q)
  > 
  > work :: Float -> SF (Float, Float, Float) Float
  > work k = proc (p, q, r) -> s where
  >    s = delay 0 (sin p) + exp r * p + q * r + exp p * exp q + k * delay 3 (q * q + r * r) * inner (p, q, r) + inner (p, q, r)
  > 
  > inner :: SF (Float, Float, Float) Float
  > inner = proc (p, q, r) -> s + s * s * s where
  >    s = delay 0 (sin p) + exp (delay 0 r) * p + q * r + exp p * exp q + delay 3 (q * q + r * r)
  > FROB
  $ frobc compile pointer.frob
  $ grep -A 3 '^static.*_step(' pointer.c
  static double pointer_inner_step(struct pointer_work_state *self,
          const struct pointer_input *in, double t1, double t2, double t3)
  {
      const double p = in->f1;
  --
  static double pointer_work_step(struct pointer_work_state *self, const struct pointer_input *in,
          double k, double t1, double t2, double t3, double t4)
  {
      const double p = in->f1;
  --
  static double pointer_other_step(struct pointer_other_state *self, double p, double q, double r,
          double t1, double t2, double t3, double t4)
  {
      const double s = self->delay + frob_exp(self->r_prev) * p + q * r + t2 * t3
  $ grep '= pointer_.*_step(' pointer.c
      const double t5 = pointer_inner_step(self, in, t1, t3, t4); /* line 11 */
      const double t5 = pointer_work_step(&self->work, in, 1.0, t1, t2, t3, t4); /* line 3 */
      const double t6 = pointer_work_step(&self->work_2, in, 2.0, t1, t2, t3, t4);
      const double t8 = pointer_other_step(&self->other, c, b, a, frob_sin(c), t2, t4, t7); /* line 3 */
      const double t9 = pointer_other_step(&self->other_2, a, b, c, t1, t3, t4, t7);
