Elements of an array with different units. The test pastes the fix.

  $ cat > state.frob <<'FROB'
  > main :: SF Velocity (Array 2 Distance)
  > main = proc v -> [integral v, v]
  > FROB
  $ frobc check state.frob
  error[E0320]: expected the unit `m`, found `m/s`
   --> state.frob:2:31
    |
  2 | main = proc v -> [integral v, v]
    |                   ----------  ^ this is `Velocity` (m/s)
    |                   |
    |                   the first element is `Distance` (m)
    |
    = hint: all elements of an array have the same unit: write a tuple, `(integral v, v)`, or a record; for an array of plain numbers, divide each element by its unit, as in `v / 1[m/s]`
  
  1 error
  [1]
  $ cat > pasted.frob <<'FROB'
  > main :: SF Velocity (Distance, Velocity)
  > main = proc v -> (integral v, v)
  > FROB
  $ frobc check pasted.frob
  $ cat > pasted.frob <<'FROB'
  > main :: SF Velocity (Array 2 Float)
  > main = proc v -> [integral v / 1[m], v / 1[m/s]]
  > FROB
  $ frobc check pasted.frob

A literal with a wrong unit:

  $ cat > literal.frob <<'FROB'
  > main :: SF Distance (Array 3 Distance)
  > main = proc d -> [d, 2[m/s], 3[m]]
  > FROB
  $ frobc check literal.frob 2>&1 | grep -e ^error -e hint
  error[E0320]: expected the unit `m`, found `m/s`
    = hint: all elements of an array have the same unit: write `2[m]`, or, for elements with different units, a tuple or a record
