Machines in a machine keep their small fields apart from the large ones, so that not
each of them pads the number of its mode to eight bytes.

  $ export CPATH=$(dirname "$(command -v frobc)")/../share/frobc/include
  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ cat > tour.frob <<'EOF'
  > main, off :: SF Float Float
  > main = switch (proc x -> (sway x + hop x, edge (x < 0))) (\_ -> off)
  > off = switch (proc x -> (-1, edge (x > 0))) (\_ -> main)
  > 
  > sway, still :: SF Float Float
  > sway = switch (proc x -> (integral x / 1[s], edge (x > 2))) (\_ -> still)
  > still = switch (proc x -> (x + 10, after 2[s] ())) (\_ -> sway)
  > 
  > hop, land :: SF Float Float
  > hop = switch (proc x -> (100 * delay 0 x, edge (x > 1))) (\_ -> land)
  > land = switch (proc _ -> (0, after 1[s] ())) (\_ -> hop)
  > EOF
  $ frobc compile tour.frob --lint
  $ sed -n '/^struct.*tour_.*{/,/^};/p' tour.h | sed 's, */\*.*,,'
  struct tour_event {
      uint8_t tag;
  };
  struct tour_input {
      double value;
  };
  struct tour_output {
      double value;
  };
  struct FROB_OVERLAID tour_sway_sway_state {
      double x_integral;
      double x_integral_input;
  };
  struct FROB_OVERLAID tour_sway_sway_flags {
      bool delay;
  };
  struct FROB_OVERLAID tour_sway_still_state {
      int64_t time;
  };
  struct FROB_OVERLAID tour_sway_state {
      union {
          struct {
              struct tour_sway_sway_state state;
          } sway;
          struct {
              struct tour_sway_still_state state;
          } still;
      } modes;
  };
  struct FROB_OVERLAID tour_sway_flags {
      union {
          struct {
              struct tour_sway_sway_flags state;
          } sway;
      } modes;
      uint8_t mode;
  };
  struct FROB_OVERLAID tour_hop_hop_state {
      double x_prev;
  };
  struct FROB_OVERLAID tour_hop_hop_flags {
      bool delay;
  };
  struct FROB_OVERLAID tour_hop_land_state {
      int64_t time;
  };
  struct FROB_OVERLAID tour_hop_state {
      union {
          struct {
              struct tour_hop_hop_state state;
          } hop;
          struct {
              struct tour_hop_land_state state;
          } land;
      } modes;
  };
  struct FROB_OVERLAID tour_hop_flags {
      union {
          struct {
              struct tour_hop_hop_flags state;
          } hop;
      } modes;
      uint8_t mode;
  };
  struct FROB_OVERLAID tour_main_main_state {
      struct tour_sway_state sway;
      struct tour_hop_state hop;
  };
  struct FROB_OVERLAID tour_main_main_flags {
      struct tour_sway_flags sway;
      struct tour_hop_flags hop;
      bool delay;
  };
  struct FROB_OVERLAID tour_main_off_state {
      bool delay;
  };
  struct FROB_OVERLAID tour_state {
      union {
          struct {
              struct tour_main_main_state state;
          } main;
      } modes;
      union {
          struct {
              struct tour_main_main_flags state;
          } main;
          struct {
              struct tour_main_off_state state;
          } off;
      } modes_flags;
      uint8_t mode;
  };
  $ cat > size.c <<'EOF'
  > #include "tour.h"
  > #include <stdio.h>
  > int main(void) { printf("%d\n", (int)sizeof(struct tour_state)); return 0; }
  > EOF
  $ gcc -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -O2 -c tour.c && gcc -std=c99 size.c -o size && ./size
  32
  $ g++ -x c++ -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -O2 -c tour.c
  $ frobc report tour.frob | sed -n '/^state/{n;p;}'
    main                              32                                tour.frob:2

Each function is given both structs, and says that they are two.

  $ grep -A1 "tour_sway_step(struct" tour.c
  static inline double tour_sway_step(struct tour_sway_state *self,
          struct tour_sway_flags *FROB_RESTRICT flags, double dt, int64_t dt_ns, double x)
  $ printf 'time,in\n0,1\n1,1.5\n2,3\n3,3\n4,1\n4.5,-1\n5,-1\n6,2\n7,2.5\n8,1\n9.5,1.5\n' > tour.csv
  $ both tour.frob tour.csv
  time,out
  0.000000000,0
  1.000000000,1
  2.000000000,13
  3.000000000,313
  4.000000000,300
  4.500000000,-1
  5.000000000,-1
  6.000000000,0
  7.000000000,212.5
  8.000000000,261
  9.500000000,0

The table for hosts finds each number.

  $ frobc trace --modes tour.frob --input tour.csv | cut -d, -f1,3-
  time,mode.main,mode.sway,mode.hop
  0.000000000,main,sway,hop
  1.000000000,main,sway,land
  2.000000000,main,still,hop
  3.000000000,main,still,hop
  4.000000000,main,sway,hop
  4.500000000,off,,
  5.000000000,off,,
  6.000000000,main,sway,hop
  7.000000000,main,still,hop
  8.000000000,main,still,hop
  9.500000000,main,sway,land

Loops have both for each round.

  $ cat > arrays.frob <<'EOF'
  > main, off :: SF Float Float
  > main = switch (proc x -> (foldl (+) 0 (mapSF sway (generate (\i -> x * toFloat i) :: Array 3 Float)), edge (x < 0))) (\_ -> off)
  > off = switch (proc x -> (-1, edge (x > 0))) (\_ -> main)
  > 
  > sway, still :: SF Float Float
  > sway = switch (proc x -> (integral x / 1[s] + delay 5 x, edge (x > 2))) (\_ -> still)
  > still = switch (proc x -> (x + 10, after 2[s] ())) (\_ -> sway)
  > EOF
  $ frobc compile arrays.frob --lint && grep "\[3\]" arrays.h | sed 's, */\*.*,,'
      struct arrays_main_main_loop_state mapSF[3];
      struct arrays_main_main_loop_flags mapSF[3];
  $ both arrays.frob tour.csv
  time,out
  0.000000000,15
  1.000000000,15
  2.000000000,29
  3.000000000,18
  4.000000000,17
  4.500000000,-1
  5.000000000,-1
  6.000000000,15
  7.000000000,20.5
  8.000000000,25
  9.500000000,18

A step on trial has copies of both.

  $ cat > parts.frob <<'EOF'
  > main, off :: SF Float Float
  > main = switch (proc x -> (circle x, edge (x < 0))) (\_ -> off)
  > off = switch (proc x -> (-1, edge (x > 0))) (\_ -> main)
  > 
  > circle :: SF Float Float
  > circle = proc x -> a + b where
  >     (a, b) = step (x, 0.5 * b + a)
  > 
  > step :: SF (Float, Float) (Float, Float)
  > step = dSwitch (proc (u, w) -> ((u, delay 1 w), edge (w > 3))) (\_ -> proc (u, w) -> (2 * u, delay 5 (w + u)))
  > EOF
  $ frobc compile parts.frob --lint && grep "trial = \|trial_2 = \|(&trial" parts.c
      struct parts_step_state trial = self->step;
      struct parts_step_flags trial_2 = flags->step;
      parts_step_step(&trial, &trial_2, x, 0.0, &a, &b);      /* line 7 */
  $ both parts.frob tour.csv
  time,out
  0.000000000,2
  1.000000000,3
  2.000000000,5.25
  3.000000000,13.125
  4.000000000,14.5625
  4.500000000,-1
  5.000000000,-1
  6.000000000,3
  7.000000000,5
  8.000000000,8.25
  9.500000000,9.125
