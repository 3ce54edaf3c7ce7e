Nested machines: the state of each machine contains those within it, and modes, of which only one
runs, share their memory.

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
  struct tour_input {
      double value;
  };
  struct tour_output {
      double value;
  };
  struct FROB_OVERLAID tour_state {
      union {
          struct {
              union {
                  struct {
                      double x_integral;
                      double x_integral_input;
                  } sway;
                  struct {
                      uint32_t time;
                  } still;
              } sway_modes;
              union {
                  struct {
                      double x_prev;
                  } hop;
                  struct {
                      uint32_t time;
                  } land;
              } hop_modes;
          } main;
          struct {
              bool delay;
          } off;
      } modes;
      uint8_t mode;
      union {
          struct {
              bool delay;
              uint8_t sway_mode;
              union {
                  struct {
                      bool delay;
                  } sway;
              } sway_modes;
              uint8_t hop_mode;
              union {
                  struct {
                      bool delay;
                  } hop;
              } hop_modes;
          } main;
      } modes_2;
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
    main                        32                                tour.frob:2

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

The table for hosts contains the offset of each mode number.

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

A loop has a machine for each iteration.

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

A step on trial works on a copy of its state.

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
  $ frobc compile parts.frob --lint && grep "trial = \|(&trial" parts.c
      struct parts_step_state trial = self->modes.main.step;
      parts_step_step(&trial, x, 0.0, &a, &b);                /* line 7 */
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
