The module Logic, compared with state machines: steps of uneven length, steps of length 0, and gaps.

  $ . ./models.sh
  $ cat > logic.frob << 'FROB'
  > import Logic
  > main :: SF (Float, Angle, Float[1/s], Float, Bool, Bool, Float) (Bool, Bool, Bool, Bool, Bool, Bool)
  > main = proc (_, _, _, _, b, r, _) ->
  >     (latch SetWins (b, r), latch ResetWins (b, r), pulse 0.3[s] b, onDelay 0.1[s] b, offDelay 0.1[s] b, flipFlop False (edge b))
  > FROB
  $ models logic
  double.c.csv: 2400 values, 0 differ
  float.c.csv: 2400 values, 0 differ

The edges: times of 0, less, and NaN; an input that is True at the first instant.

  $ . ./trace.sh
  $ cat > edges.frob << 'FROB'
  > import Logic
  > main :: SF (Bool, Time) (Array 6 Bool)
  > main = proc (b, _) -> [pulse 0 b, pulse less b, pulse (0/0) b, onDelay less b, offDelay less b, offDelay (0/0) b] where
  >     less = -1[s]
  > FROB
  $ printf '%s\n' true,0 true,0 false,0 true,0 | rows in.1,in.2 | trace edges | cells
  false,false,false,true,true,true
  false,false,false,true,true,true
  false,false,false,false,false,false
  false,false,false,true,true,true
