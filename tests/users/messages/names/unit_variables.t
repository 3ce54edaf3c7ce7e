Words in place of unit variables. The test applies each fix.

  $ cat > keyword.frob <<'FROB'
  > half :: Float[unit] -> Float[unit]
  > half x = x / 2
  > main :: SF Distance Distance
  > main = proc d -> half d
  > FROB
  $ frobc check keyword.frob
  error[E0110]: expected a unit after `[`, found `unit`
   --> keyword.frob:1:15
    |
  1 | half :: Float[unit] -> Float[unit]
    |               ^^^^
    |
    = hint: `unit` is a keyword: for any unit, write a single letter: `half :: Float[u] -> Float[u]`
  
  1 error
  [1]
  $ sed 's/.unit./[u]/g' keyword.frob > pasted.frob && frobc check pasted.frob

  $ cat > words.frob <<'FROB'
  > half :: Float[un] -> Float[un]
  > half x = x / 2
  > area :: Float[len] -> Float[width] -> Float[len*width]
  > area x y = x * y
  > main :: SF Distance Float[m^2]
  > main = proc d -> area d (half d)
  > FROB
  $ frobc check words.frob
  error[E0208]: unknown unit `un`
   --> words.frob:1:15
    |
  1 | half :: Float[un] -> Float[un]
    |               ^^           -- and here
    |
    = hint: for any unit, write a single letter: `half :: Float[u] -> Float[u]`
  
  error[E0208]: unknown unit `len`
   --> words.frob:3:15
    |
  3 | area :: Float[len] -> Float[width] -> Float[len*width]
    |               ^^^                           --- and here
    |
    = hint: for any unit, write a single letter: `area :: Float[l] -> Float[width] -> Float[l*width]`
  
  error[E0208]: unknown unit `width`
   --> words.frob:3:29
    |
  3 | area :: Float[len] -> Float[width] -> Float[len*width]
    |                             ^^^^^               ----- and here
    |
    = hint: for any unit, write a single letter: `area :: Float[len] -> Float[w] -> Float[len*w]`
  
  3 errors
  [1]
  $ frobc fix --all words.frob > /dev/null 2>&1; cat words.frob; frobc check words.frob
  half :: Float[u] -> Float[u]
  half x = x / 2
  area :: Float[l] -> Float[w] -> Float[l*w]
  area x y = x * y
  main :: SF Distance Float[m^2]
  main = proc d -> area d (half d)

A unit with a similar name comes first, and a declaration has no unit variables of its own:

  $ cat > similar.frob <<'FROB'
  > data Reading = Reading { value :: Float[range] }
  > slow :: Float[m/sec] -> Bool
  > slow v = v < 1[m/s]
  > main :: SF Velocity Bool
  > main = arr slow
  > FROB
  $ frobc check similar.frob 2>&1 | grep -e ^error -e hint
  error[E0208]: unknown unit `range`
  error[E0208]: unknown unit `sec`
    = hint: did you mean `s`?
