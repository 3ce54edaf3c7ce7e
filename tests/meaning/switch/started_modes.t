When a mode starts, it takes its first step: no time has passed, delays have their initial values,
and an inner machine is in its first mode.

  $ both () { frobc trace "$1" --input "$2" > c.csv && frobc trace "$1" --input "$2" --engine interp | diff c.csv - && cat c.csv; }
  $ cat > inside.frob <<'EOF'
  > main, work :: SF Float Float
  > main = switch (proc x -> (x, edge (x > 1))) (\_ -> work)
  > work = switch (proc x -> (ramp x + delay 7 x, edge (x < 0))) (\_ -> main)
  > 
  > ramp, flat :: SF Float Float
  > ramp = switch (proc x -> (10 + integral x / 1[s], edge (x > 3))) (\_ -> flat)
  > flat = switch (proc _ -> (time () / 1[s], after 2[s] ())) (\_ -> ramp)
  > EOF
  $ frobc compile inside.frob --lint

The first mode of the program does not use the time, so the state has no flag for its first step;
the first dt is ignored.

  $ sed -n '/^void inside_reset/,/^}/p' inside.c | sed 's, */\*.*,,'
  void inside_reset(struct inside_state *self)
  {
      self->mode = INSIDE_MAIN;
      inside_main_main_reset(self);
  }
  $ printf 'time,in\n5,0\n6,2\n7,1\n8,4\n9,4\n10,4\n11,2\n12,-1\n13,2\n' > inside.csv
  $ both inside.frob inside.csv
  time,out
  5.000000000,0
  6.000000000,17
  7.000000000,14
  8.000000000,1
  9.000000000,5
  10.000000000,14
  11.000000000,18
  12.000000000,-1
  13.000000000,17
