`NAME_is_valid` tells whether the number of each running mode exists. A mode that does not run, and
whose memory another mode uses, is not looked at.

  $ installed=$(dirname "$(command -v frobc)")/..
  $ export CPATH=$installed/share/frobc/include library=$installed/lib/frobc/libfrob.a
  $ cat > nested.frob <<'EOF'
  > blink :: SF Bool Int
  > blink = switch (proc b -> (0, edge b)) (\_ -> off)
  > 
  > off :: SF Bool Int
  > off = switch (proc b -> (1, edge (not b))) (\_ -> blink)
  > 
  > main :: SF (Bool, Array 3 Bool) (Int, Int)
  > main = proc (b, bs) -> (outer b, foldl (+) 0 (mapSF blink bs))
  > 
  > outer :: SF Bool Int
  > outer = switch (proc b -> (7, after 1[s] () `tag` b)) (\b -> inner b)
  > 
  > inner :: Bool -> SF Bool Int
  > inner first = proc b -> 10 + n where
  >     n = blink (b || first)
  > EOF
  $ frobc compile nested.frob
  $ sed -n '/_is_valid(/,/^}/p' nested.c
  static bool nested_blink_is_valid(const struct nested_blink_state *self)
  {
      return self->mode <= NESTED_BLINK_OFF;
  }
  static bool nested_main_loop_is_valid(const struct nested_main_loop_state *self)
  {
      return nested_blink_is_valid(&self->blink);
  }
  bool nested_is_valid(const struct nested_state *self)
  {
      bool valid = true;
      for (int32_t i = 0; i < 3; i++) {
          valid = valid && nested_main_loop_is_valid(&self->mapSF[i]);
      }
      valid = valid && self->outer_mode <= NESTED_OUTER_INNER;
      if (valid && self->outer_mode == NESTED_OUTER_INNER) {
          valid = valid && nested_blink_is_valid(&self->outer_modes.inner.blink);
      }
      return valid;
  }
  $ cat > damage.c <<'EOF'
  > #include "nested.h"
  > #include <stdio.h>
  > int main(void) {
  >     static struct nested_state state;
  >     struct nested_input in = {false};
  >     struct nested_output out;
  >     unsigned char *bytes = (unsigned char *)&state;
  >     nested_reset(&state);
  >     for (int k = 0; k < 20; k++) {
  >         unsigned found = 0;
  >         in.f1 = k % 3 == 0;
  >         in.f2[k % 3] = k % 2;
  >         nested_step(&state, k == 0 ? 0 : 0.1, &in, &out);
  >         for (unsigned i = 0; i < sizeof state; i++) {
  >             const unsigned char before = bytes[i];
  >             bytes[i] = 77;
  >             found += !nested_is_valid(&state);
  >             bytes[i] = before;
  >         }
  >         if (k % 6 == 0)
  >             printf("%d: %d, and damage of %u bytes is found\n", k, nested_is_valid(&state), found);
  >     }
  >     return 0;
  > }
  > EOF
  $ gcc -std=c99 -O2 -Wall -Wextra -Werror -o damage damage.c nested.c $library -lm
  $ ./damage
  0: 1, and damage of 4 bytes is found
  6: 1, and damage of 4 bytes is found
  12: 1, and damage of 5 bytes is found
  18: 1, and damage of 5 bytes is found

A program without modes has no such function.

  $ printf 'main :: SF Float Float\nmain = arr (+ 1)\n' > plain.frob
  $ frobc compile plain.frob && grep is_valid plain.h plain.c
  [1]

A component in C writes beyond its own memory, over the number of the running mode. Hosts do not
run another step:

  $ cat > count.h <<'EOF'
  > #ifndef COUNT_H
  > #define COUNT_H
  > struct count_state { unsigned char last[2]; };
  > #endif
  > EOF
  $ cat > count.c <<'EOF'
  > #include "runs.h"
  > static int n;
  > void count_reset(struct count_state *self) { self->last[0] = 0; n = 0; }
  > void count_step(struct count_state *self, double dt, const struct count_input *in,
  >                 struct count_output *out)
  > {
  >     unsigned char *last = self->last;
  >     (void)dt;
  >     (void)in;
  >     for (int i = 0; i < 8 && n >= 3; i++)
  >         last[i] = 99;
  >     out->value = ++n;
  > }
  > EOF
  $ cat > runs.frob <<'EOF'
  > foreign include "count.h"
  > foreign sf count :: SF Bool Int = "count"
  > 
  > main :: SF Bool (Int, Int)
  > main = proc b -> (count b, walk b)
  > 
  > walk :: SF Bool Int
  > walk = switch (proc b -> (0, edge b)) (\_ -> constant 1)
  > EOF
  $ printf 'time,in\n0,False\n0.5,False\n1,False\n1.5,False\n2,False\n2.5,False\n' > in.csv
  $ frobc trace runs.frob --with count.c --with count.h --input in.csv
  error: in.csv:6:1: the state of runs is damaged: the number of a running mode is invalid; if the program calls C functions, check that they write only to their own memory
  time,out.1,out.2
  0.000000000,1,0
  0.500000000,2,0
  1.000000000,3,0
  1.500000000,4,1
  [2]
