A mode that ends at an occurrence of `after` does not store that the event has occurred, and only
counts the nanoseconds that are left.

  $ cat > pause.frob <<'EOF'
  > main :: SF Float Float
  > main = switch (proc _ -> (0, after 1.5[s] ())) (\_ -> go)
  > 
  > go, pause :: SF Float Float
  > go = switch (proc x -> (x, edge (x > 9))) (\_ -> pause)
  > pause = switch (proc x -> (-x, after 2[s] ())) (\_ -> go)
  > EOF
  $ frobc compile pause.frob --lint --dump=flow | grep -A3 "nanoseconds"
    _3 : Float = nanoseconds(_2)
    _4 : Bool = 1500000000.0 <= _3
    when _4 -> main.go
    -> (out = 0.0)
  --
    _3 : Float = nanoseconds(_2)
    _4 : Bool = 2000000000.0 <= _3
    when _4 -> main.go
    -> (out = _1)
  $ frobc compile pause.frob
  $ grep "reached" pause.c | sed "s, */.*,,"
      const bool reached = frob_runs_out(&self->modes.main.time, dt_ns);
      const bool t1 = reached;
      const bool reached = frob_runs_out(&self->modes.pause.time, dt_ns);
      const bool t1 = reached;

An edge needs its previous value, which is initially True.

  $ grep "delay" pause.h | sed "s, */.*,,"
              bool delay;

Both engines agree, also if a time is reached exactly.

  $ cat > in.csv <<'EOF'
  > time,in
  > 0,1
  > 1,10
  > 1.499999999,10
  > 1.5,10
  > 2,10
  > 3,5
  > 4,10
  > 5.999999999,10
  > 6.000000001,10
  > 7,3
  > 8,10
  > 10,3
  > EOF
  $ frobc trace pause.frob --input in.csv | tee c.csv | cut -d, -f2
  out
  0
  0
  0
  10
  10
  5
  -10
  -10
  10
  3
  -10
  3
  $ frobc trace pause.frob --input in.csv --engine interp | cmp - c.csv

A latch is kept if the mode's own output depends on it, and if another condition
ends the mode.

  $ cat > shown.frob <<'EOF'
  > main :: SF (Bool, Bool) Bool
  > main = switch (proc (a, b) -> (seen a, edge b)) (\_ -> main)
  > 
  > seen :: SF Bool Bool
  > seen = proc a -> y where
  >   y = a || delay False y
  > EOF
  $ frobc compile shown.frob
  $ grep "delay\|prev" shown.h | sed "s, */.*,,"
   *   shown_step with the seconds since the previous instant, or
              bool y_prev;
              bool b_prev;
  $ printf 'time,in.1,in.2\n0,false,false\n1,true,false\n2,false,false\n3,false,true\n4,false,false\n' > in.csv
  $ frobc trace shown.frob --input in.csv | tee c.csv | cut -d, -f2
  out
  false
  true
  true
  false
  false
  $ frobc trace shown.frob --input in.csv --engine interp | cmp - c.csv
