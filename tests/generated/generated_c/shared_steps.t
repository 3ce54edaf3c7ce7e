A step that several modes have in common is one function, which compilers are asked not to copy
into each of them; two of it side by side, or a short one, are for them to decide.

  $ cat > rover.frob <<'EOF'
  > data Sensed = Sensed { ahead, side, speed :: Float }
  > 
  > follow :: Float -> SF Sensed (Float, Float)
  > follow d = proc i -> (v, omega) where
  >     v = max (-0.3) (min 0.3 (1.2 * (i.ahead - d)))
  >     omega = 4 * (max (-0.5 * i.speed) (min (0.5 * i.speed) (2 * (i.side - d))) - integral (i.side - d) / 10[s])
  > 
  > turn :: SF Sensed (Float, Float)
  > turn = proc i -> (0, 2 * i.side)
  > 
  > main :: SF Sensed (Float, Float)
  > main = proc i -> either id id (runTask (forever round') i)
  > 
  > round' :: Task Sensed (Float, Float) ()
  > round' = do
  >     mkTask (proc i -> (follow 0.3 i, when (i.ahead < 0.2)))
  >     mkTask (proc i -> (turn i, when (i.ahead > 0.5)))
  >     follow 0.2 `mkTaskFor` 5[s]
  >     turn `mkTaskFor` 1[s]
  > 
  > mkTaskFor :: SF Sensed (Float, Float) -> Time -> Task Sensed (Float, Float) ()
  > mkTaskFor sf q = mkTask (sf &&& after q)
  > EOF
  $ frobc compile rover.frob --lint
  $ grep 'static FROB_SHARED' rover.c
  static FROB_SHARED void rover_follow_step(struct rover_follow_state *self, double dt,

  $ sed 's/^main = .*/main = proc i -> let (a, b) = follow 0.3 i; (c, d) = follow 0.2 i in (a + c, b + d)/' rover.frob > pair.frob
  $ frobc compile pair.frob --lint
  $ grep -c 'static FROB_SHARED' pair.c
  0
  [1]
