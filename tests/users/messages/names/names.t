Unknown names: different capitals, units as words, features of a later version.

  $ cat > true.frob <<'FROB'
  > ready = true
  > FROB
  $ frobc check true.frob
  error[E0205]: unknown name `true`
   --> true.frob:1:9
    |
  1 | ready = true
    |         ^^^^
    |
    = hint: did you mean `True`?
  
  1 error
  [1]

  $ cat > capital.frob <<'FROB'
  > Speed = 0.4[m/s]
  > FROB
  $ frobc check capital.frob
  error[E0226]: a top-level definition defines one name, not a pattern
   --> capital.frob:1:1
    |
  1 | Speed = 0.4[m/s]
    | ^^^^^^^^^^^^^^^^
    |
    = hint: start the name of a value with a lower-case letter: `speed`
  
  1 error
  [1]

  $ cat > units.frob <<'FROB'
  > v = 0.2[meters/sec]
  > FROB
  $ frobc check units.frob
  error[E0208]: unknown unit `meters`
   --> units.frob:1:9
    |
  1 | v = 0.2[meters/sec]
    |         ^^^^^^
    |
    = hint: did you mean `m`?
  
  error[E0208]: unknown unit `sec`
   --> units.frob:1:16
    |
  1 | v = 0.2[meters/sec]
    |                ^^^
    |
    = hint: did you mean `s`?
  
  2 errors
  [1]

  $ cat > unimported.frob <<'FROB'
  > origin = Geometry.zeroVec
  > FROB
  $ frobc check unimported.frob
  error[E0215]: no module `Geometry` is imported here
   --> unimported.frob:1:10
    |
  1 | origin = Geometry.zeroVec
    |          ^^^^^^^^
    |
    = hint: the library has this module: add `import qualified Geometry`
  
  1 error
  [1]

A `where` after `proc … -> do` cannot use the signals.

  $ cat > where.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> do
  >     y <- delay 0 -< x
  >     returnA -< y + z
  >   where
  >     z = 2 * y
  > FROB
  $ frobc check where.frob
  error[E0205]: unknown name `y`
   --> where.frob:6:13
    |
  3 |     y <- delay 0 -< x
    |     - this `y` is a signal of the `proc`
  ...
  6 |     z = 2 * y
    |             ^
    |
    = hint: a `where` after `do` belongs to the whole definition and cannot use signals: write a `let` in the `do`
  
  1 error
  [1]

An equation is not an assignment; parameters have other errors.

  $ cat > twice.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> n where
  >     n = 0
  >     n = n + x
  > 
  > f x x = x
  > FROB
  $ frobc check twice.frob
  error[E0212]: `n` is defined twice here
   --> twice.frob:4:5
    |
  3 |     n = 0
    |     - first defined here
  4 |     n = n + x
    |     ^
    |
    = hint: write one equation, in which `delay` returns the previous value: `n = delay 0 n + x`
  
  error[E0212]: `x` is defined twice here
   --> twice.frob:6:5
    |
  6 | f x x = x
    |   - ^
    |   |
    |   first defined here
  
  2 errors
  [1]

A field that not every value of the type has.

  $ cat > held.frob <<'FROB'
  > data State = Free | Held { spot :: Float }
  > main :: SF State Float
  > main = arr (\s -> s.spot)
  > FROB
  $ frobc check held.frob
  error[E0310]: not every `State` has the field `spot`
   --> held.frob:3:21
    |
  3 | main = arr (\s -> s.spot)
    |                   - ^^^^
    |                   |
    |                   this is `State`
    |
    = hint: only `Held` has it: use a `case` with the pattern `Held { spot = x }`
  
  1 error
  [1]
