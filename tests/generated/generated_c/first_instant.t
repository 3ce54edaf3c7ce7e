What is short at the first instant stands in a branch of its own; the other branch
knows that it is not the first. The dt that comes then is looked at by nobody.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > button.frob <<'EOF'
  > import Control
  > 
  > -- | How often a button was pressed that bounces.
  > main :: SF Bool Int
  > main = proc b -> hold 0 (count (edge (debounce 30[ms] b)))
  > EOF
  $ frobc compile button.frob --lint
  $ sed -n '/^void button_step/,$p' button.c
  void button_step(struct button_state *self, double dt, const struct button_input *in,
          struct button_output *out)
  {
      const bool b = in->value;
      if (!self->started) {                                   /* Control.frob:26 */
          self->debounce_before = b;                          /* Prelude.frob:379 */
          self->started = true;                               /* Control.frob:26 */
      } else {
          int64_t dt_ns = frob_whole_ns(dt);
          const bool differs = b != self->debounce_before;    /* Control.frob:95 */
          self->time = differs && self->waiting ? frob_soon(self->time, dt_ns) : 0; /* Prelude.frob:343 */
          const bool settled = INT64_C(30000000) <= self->time; /* Control.frob:98 */
          const bool t1 = settled && b && !self->debounce_before; /* Prelude.frob:379 */
          if (settled) {
              self->debounce_before = b;
          }
          const int32_t y = t1 ? frob_int_add(self->before, 1) : self->before; /* Prelude.frob:438 */
          if (t1) {                                           /* Prelude.frob:404 */
              self->hold_y_prev = y;
          }
          self->waiting = differs && !settled;                /* Control.frob:96 */
          self->before = y;                                   /* Prelude.frob:437 */
      }
      out->value = self->hold_y_prev;                         /* Prelude.frob:404 */
  }
  $ cat > button.csv <<'EOF'
  > time,in
  > 0,true
  > 0.02,true
  > 0.04,false
  > 0.06,false
  > 0.08,false
  > 0.1,true
  > 0.11,false
  > 0.12,true
  > 0.14,true
  > 0.16,true
  > EOF
  $ frobc trace button.frob --input button.csv | tail -2
  0.140000000,0
  0.160000000,1
  $ frobc trace button.frob --input button.csv --engine interp > other.csv
  $ frobc trace button.frob --input button.csv | cmp - other.csv
  $ cat > drive.c <<'EOF'
  > #include "button.h"
  > #include <stdio.h>
  > int main(void)
  > {
  >     const bool held[] = {false, true, true, true};
  >     struct button_state state;
  >     button_reset(&state);
  >     for (int i = 0; i < 4; i++) {
  >         struct button_input in = {held[i]};
  >         struct button_output out;
  >         button_step(&state, i == 0 ? 1e9 : 0.02, &in, &out);
  >         printf("%d\n", (int)out.value);
  >     }
  >     return 0;
  > }
  > EOF
  $ flags="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
  $ gcc -std=c99 $flags drive.c button.c -o drive && ./drive
  0
  0
  0
  1
  $ for level in -O0 -O2; do
  >   clang -std=c99 $level $flags -c button.c -o b.o &&
  >   g++ -std=c++17 -x c++ $level $flags -c button.c -o c.o && clang++ -std=c++17 -x c++ $level $flags -c button.c -o d.o
  > done

Where an output is computed in each instant from what is known then, there is no such
branch: it would stand there twice.

  $ cat > smooth.frob <<'EOF'
  > import Control
  > 
  > main :: SF Float Float
  > main = proc x -> 2 * lowPass 1[s] x
  > EOF
  $ frobc compile smooth.frob
  $ grep 'started' smooth.c
      self->started = false;                                  /* Control.frob:26 */
      dt = self->started ? dt : 0.0;
      const double y = self->started
      self->started = true;                                   /* Control.frob:26 */
