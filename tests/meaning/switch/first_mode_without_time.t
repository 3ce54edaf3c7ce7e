If the first mode of a machine does not use the time, the state needs no flag for the first instant,
whose dt may be anything: the mode that follows in that instant starts with a dt of 0.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ cat > alarm.frob <<'EOF'
  > watch, ring :: SF Bool Float
  > watch = switch (proc b -> (0, when b)) (\_ -> ring)
  > ring = switch (proc _ -> (1 + time () / 1[s], after 2[s] ())) (\_ -> watch)
  > main = watch
  > EOF
  $ frobc compile alarm.frob
  $ grep -c 'START\|started' alarm.c alarm.h
  alarm.c:0
  alarm.h:0
  [1]
  $ cat > first_dt.c <<'EOF'
  > #include "alarm.h"
  > #include <stdio.h>
  > int main(void)
  > {
  >     struct alarm_state state;
  >     struct alarm_input in = {true};
  >     struct alarm_output out;
  >     alarm_reset(&state);
  >     alarm_step(&state, 1e9, &in, &out);
  >     printf("%g\n", out.value);
  >     in.value = false;
  >     for (int i = 0; i < 3; i++) {
  >         alarm_step(&state, 1.0, &in, &out);
  >         printf("%g\n", out.value);
  >     }
  >     return 0;
  > }
  > EOF
  $ gcc -std=c99 -Wall -Wextra -Werror first_dt.c alarm.c -o first_dt && ./first_dt
  1
  2
  0
  0

A first mode that uses the time needs the flag.

  $ sed 's/main = watch/main = ring/' alarm.frob > rings.frob
  $ frobc compile rings.frob
  $ grep 'started' rings.h
      bool started; /* true after the first instant at rings.frob:4 */
