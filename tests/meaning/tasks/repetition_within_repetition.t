Nested repetitions. An inner repetition that is not empty takes time, so the outer one takes time
too: the number of iterations is known if it is a literal, and an array has at least one element.

  $ . ./trace.sh
  $ cat > rounds.frob <<'FROB'
  > main :: SF Float (Either Float Int)
  > main = runTask (do
  >     repeatT 2 (repeatT 3 (sleepT 0.5[s] 1))
  >     forEachT [[1, 2], [3, 4]] (\row -> forEachT row (\y -> sleepT 0.5[s] y))
  >     return 7)
  > FROB
  $ yes 0 | head -12 | rows in | trace rounds | cut -d, -f2 | xargs
  out Left 1 Left 1 Left 1 Left 1 Left 1 Left 1 Left 1 Left 2 Left 3 Left 4 Right 7 Right 7

An inner repetition may be empty if the outer one is bounded:

  $ cat > maybe.frob <<'FROB'
  > pause :: Int -> Task Float Float ()
  > pause n = repeatT n (sleepT 0.5[s] (toFloat n))
  > 
  > main :: SF Float (Either Float ())
  > main = runTask (repeatT 2 (forEachT [0, 1] pause))
  > FROB
  $ yes 0 | head -4 | rows in | trace maybe | cut -d, -f2 | xargs
  out Left 1 Left 1 Right () Right ()
