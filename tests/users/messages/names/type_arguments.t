Types whose arguments need parentheses or do not exist. The test pastes each fix.

  $ cat > event.frob <<'FROB'
  > main :: SF Bool Event ()
  > main = proc b -> edge b
  > FROB
  $ frobc check event.frob
  error[E0216]: type `SF` takes 2 type arguments, not 3
   --> event.frob:1:9
    |
  1 | main :: SF Bool Event ()
    |         ^^^^^^^^^^^^^^^^
    |
    = hint: add parentheses: `SF Bool (Event ())`
  
  1 error
  [1]
  $ frobc fix --all event.frob > /dev/null 2>&1; cat event.frob; frobc check event.frob
  main :: SF Bool (Event ())
  main = proc b -> edge b

  $ cat > nested.frob <<'FROB'
  > data Pair a b = Pair a b
  > f :: Pair Maybe Array 3 Float Maybe Int -> Maybe Array 3 Float -> Bool
  > f x y = True
  > main :: SF Bool Event Maybe Int
  > main = proc b -> NoEvent
  > FROB
  $ frobc check nested.frob 2>&1 | grep -e ^error -e hint
  error[E0216]: type `Pair` takes 2 type arguments, not 6
    = hint: add parentheses: `Pair (Maybe (Array 3 Float)) (Maybe Int)`
  error[E0216]: type `Maybe` takes 1 type argument, not 3
    = hint: add parentheses: `Maybe (Array 3 Float)`
  error[E0216]: type `SF` takes 2 type arguments, not 4
    = hint: add parentheses: `SF Bool (Event (Maybe Int))`
  $ frobc fix --all nested.frob > /dev/null 2>&1; frobc check nested.frob
