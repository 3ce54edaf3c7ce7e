A local time stops at its maximum, after 292 years. If a mode ends long before that, its time is
added up without that check. If a time is only compared with small constants, the state stores how
much is left until the largest of them.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ advances () { frobc compile "$1".frob --lint && grep -E "frob_(soon|later|remaining|runs)" "$1".c | sed "s, */\*.*,,"; }
  $ cat > ends.frob <<'EOF'
  > main :: SF Float Float
  > main = switch (proc x -> (x, mergeE (after 5[s] ()) (edge (x > 3)))) (\_ -> switch (proc _ -> (5, after 6[s] ())) (\_ -> main))
  > EOF
  $ advances ends
      self->modes.main.time = frob_soon(self->modes.main.time, dt_ns);
      self->modes.main_2.time = frob_soon(self->modes.main_2.time, dt_ns);

The check is needed if something else ends the mode, if the limit is near the maximum, or if the
time alone does not end the mode.

  $ cat > goes_on.frob <<'EOF'
  > main :: SF Float Float
  > main = switch (proc x -> (time () / 1[s], edge (x > 3))) (\_ -> switch (proc x -> (x, after 5e9[s] ())) (\_ -> never_again))
  > 
  > never_again :: SF Float Float
  > never_again = switch (proc x -> (x, gate (after 2[s] ()) (x > 3))) (\_ -> main)
  > EOF
  $ advances goes_on
      self->modes.main.time = frob_later(self->modes.main.time, dt_ns);
      self->modes.main_2.time = frob_later(self->modes.main_2.time, dt_ns);
      const bool reached = frob_runs_out(&self->modes.never_again.time, dt_ns);

It is also needed if the time restarts, whether the time itself determines when, as in `debounce`,
or the input.

  $ cat > settles.frob <<'EOF'
  > import Control
  > 
  > main :: SF Bool Bool
  > main = proc b -> debounce 30[ms] b
  > EOF
  $ advances settles
      const bool reached = frob_runs_out_while(self->waiting, &self->since, dt_ns, 30000000);
  $ cat > held.frob <<'EOF'
  > main :: SF Bool Bool
  > main = proc b -> nanoseconds (timeSince b) >= nanoseconds 2[s]
  > EOF
  $ advances held
      const bool reached = frob_runs_out_while(!b, &self->time, dt_ns, 2000000000);

In a signal function with its own instants, dt may be arbitrarily long: here no event comes for 380
years. A recording cannot represent this, because its times are below 10^9 s.

  $ cat > seldom.frob <<'EOF'
  > main :: SF (Event Float) (Event Float)
  > main = onEvent (switch (proc x -> (x, after 5[s] ())) (\_ -> constant (-1)))
  > EOF
  $ advances seldom
      self->modes.main.time = frob_later(self->modes.main.time, dt_ns);
          self->since = frob_later(self->since, dt_ns);
  $ cat > drive.c <<'EOF'
  > #include "seldom.h"
  > #include <stdio.h>
  > int main(void)
  > {
  >     struct seldom_state state;
  >     struct seldom_input in = {{SELDOM_EVENT_FLOAT_EVENT, 1}};
  >     struct seldom_output out;
  >     seldom_reset(&state);
  >     for (int i = 0; i <= 13; i++) {
  >         in.value.tag = i < 2 || i == 13 ? SELDOM_EVENT_FLOAT_EVENT : SELDOM_EVENT_FLOAT_NO_EVENT;
  >         seldom_step(&state, i < 2 ? 3 : 1e9, &in, &out);
  >         if (out.value.tag == SELDOM_EVENT_FLOAT_EVENT)
  >             printf("%g\n", out.value.f0);
  >     }
  >     return 0;
  > }
  > EOF
  $ gcc -std=c99 drive.c seldom.c -o drive && ./drive
  1
  1
  -1
