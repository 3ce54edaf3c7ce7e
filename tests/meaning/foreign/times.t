A component receives the seconds since its own last step, 0 at its first one: in modes, at its own
rate, only at occurrences, and after a delayed switch.

  $ cat > clock.h <<'EOF'
  > struct dt_state { int steps; };
  > EOF
  $ cat > dt.c <<'EOF'
  > #include "times.h"
  > void dt_reset(struct dt_state *self) { self->steps = 0; }
  > void dt_step(struct dt_state *self, double dt, const struct dt_input *in, struct dt_output *out) {
  >     out->value = in->value > 0 ? dt : -1;
  >     self->steps++;
  > }
  > EOF
  $ cat > times.frob <<'EOF'
  > foreign include "clock.h"
  > 
  > -- | The seconds since its own last step, as C gets them.
  > foreign sf dt :: SF Float Time = "dt"
  > 
  > main :: SF Float (Time, Time, Event Time, Time, Event Time, Time)
  > main = proc x -> (dt x, ofMode x, sampleEvery 1[s] dt x, twice x, onEvent dt (if x > 2 then Event x else NoEvent), late x)
  > 
  > -- | 0 where a mode begins.
  > ofMode :: SF Float Time
  > ofMode = switch (proc x -> (dt x, edge (x > 2))) (\_ -> dt)
  > 
  > late :: SF Float Time
  > late = dSwitch (proc x -> (dt x, edge (x > 2))) (\_ -> proc x -> dt x + 100[s])
  > 
  > twice :: SF Float Time
  > twice = proc x -> dt x + integral (dt x / 1[s])
  > EOF
  $ printf 'time,in\n0,1\n0.5,2\n1.1,3\n1.6,1\n2.3,5\n3.3,1\n' > in.csv
  $ frobc trace --lint times.frob --with dt.c --with clock.h --input in.csv
  time,out.1,out.2,out.3,out.4,out.5,out.6
  0.000000000,0,0,0,0,,0
  0.500000000,0.5,0.5,,0.5,,0.5
  1.100000000,0.59999999999999998,0,1.1000000000000001,0.89999999999999991,0,0.59999999999999998
  1.600000000,0.5,0.5,,1.1000000000000001,,100.5
  2.300000000,0.69999999999999996,0.69999999999999996,1.2,1.6499999999999999,1.2,100.7
  3.300000000,1,1,1,2.6499999999999999,,101
