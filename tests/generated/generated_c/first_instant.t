`NAME_step` ignores the dt of the first instant. It recognizes this instant by a delay that the
program already has, or else by a flag.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > button.frob <<'EOF'
  > import Control
  > 
  > -- | How often a button was pressed that bounces.
  > main :: SF Bool Int
  > main = proc b -> hold 0 (count (edge (debounce 30[ms] b)))
  > EOF
  $ frobc compile button.frob --lint
  $ grep 'started' button.c
      self->started = false;                                  /* Control.frob:36 */
      const bool start = !self->started;                      /* Control.frob:36 */
      self->started = true;                                   /* Control.frob:36 */
      int64_t dt_ns = self->started ? frob_whole_ns(dt) : 0;
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
