A `Bool` where a `Verdict` is expected: the hint keeps the condition.

  $ cat > judge.frob <<'FROB'
  > import Robot
  > import Trial
  > 
  > main = reactimateTask (watching (forward 1[m]))
  > 
  > trial "touches nothing" = Trial {
  >     world = "room.toml", lasts = 60[s], seeds = 1 `to` 5,
  >     judge = proc t -> not t.touches
  > }
  > FROB
  $ frobc check judge.frob
  error[E0301]: expected `Verdict`, found `Bool`
   --> judge.frob:8:23
    |
  8 |     judge = proc t -> not t.touches
    |     -----             ^^^^^^^^^^^^^
    |     |
    |     the output of the field `judge` is `Verdict`
    |
    = hint: turn the `Bool` into a `Verdict`: write `verdict (not t.touches)`
  
  1 error
  [1]
  $ sed 's/-> not t.touches/-> verdict (not t.touches)/' judge.frob > cured.frob
  $ frobc check cured.frob

As an argument, the call needs parentheses:

  $ cat > argument.frob <<'FROB'
  > worst :: Verdict -> Verdict
  > worst v = v
  > 
  > main :: SF Bool Verdict
  > main = proc b -> worst b
  > FROB
  $ frobc check argument.frob
  error[E0301]: expected `Verdict`, found `Bool`
   --> argument.frob:5:24
    |
  5 | main = proc b -> worst b
    |                  ----- ^
    |                  |
    |                  argument 1 of `worst` is `Verdict`
    |
    = hint: turn the `Bool` into a `Verdict`: write `(verdict b)`
  
  1 error
  [1]
  $ sed 's/worst b/worst (verdict b)/' argument.frob > cured.frob
  $ frobc check cured.frob

The hint lists the values of a type only where a value is written out:

  $ cat > cases.frob <<'FROB'
  > data Gait = Walk | Trot | Canter | Gallop
  > 
  > main :: SF Float Gait
  > main = proc v -> GAIT
  > FROB
  $ sed 's/GAIT/v/' cases.frob > value.frob
  $ frobc check value.frob
  error[E0301]: expected `Gait`, found `Float`
   --> value.frob:4:18
    |
  3 | main :: SF Float Gait
    |         ------------- the signature of `main` requires the output `Gait`
  4 | main = proc v -> v
    |                  ^
  
  1 error
  [1]
  $ sed 's/GAIT/"trot"/' cases.frob > text.frob
  $ frobc check text.frob
  error[E0301]: expected `Gait`, found `String`
   --> text.frob:4:18
    |
  3 | main :: SF Float Gait
    |         ------------- the signature of `main` requires the output `Gait`
  4 | main = proc v -> "trot"
    |                  ^^^^^^
    |
    = hint: use `Walk`, `Trot`, `Canter` or `Gallop`
  
  1 error
  [1]
