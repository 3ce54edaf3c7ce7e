Functions over all elements of an array. In a tie the first element wins, and NaN never wins over a
number.

  $ cat > folds.frob <<'FROB'
  > main :: SF (Array 4 Float) ((Float, Array 4 Float, Bool, Bool), (Float, Float, Float), Array 4 (Float, Int), Array 4 Float, Array 4 Float, Int)
  > main = proc xs ->
  >     ( (foldl (-) 10 xs, scanl (-) 10 xs, any (> 2) xs, all (> 0) xs)
  >     , (minimumBy abs xs, maximumBy abs xs, bestBy (\a b -> abs (a - 2) < abs (b - 2)) id xs)
  >     , imap (\i x -> (x, i)) xs
  >     , zipWith (*) xs (generate toFloat)
  >     , replace 1 0 (map negate xs)
  >     , length xs
  >     )
  > FROB
  $ cat > in.csv <<'CSV'
  > time,in[0],in[1],in[2],in[3]
  > 0,1,2,3,4
  > 1,-4,1,-1,4
  > 2,nan,3,-1,nan
  > 3,nan,nan,nan,nan
  > CSV
  $ frobc trace folds.frob --input in.csv > c.csv
  $ frobc trace folds.frob --input in.csv --engine interp | cmp - c.csv
  $ columns() { echo "$1"; cut -d, -f "$2" c.csv | sed 1d; }
  $ columns 'foldl, scanl, any, all' 2-8
  foldl, scanl, any, all
  0,9,7,4,0,true,true
  10,14,13,14,10,true,false
  nan,nan,nan,nan,nan,true,false
  nan,nan,nan,nan,nan,false,false
  $ columns 'minimumBy, maximumBy, bestBy' 9-11
  minimumBy, maximumBy, bestBy
  1,4,2
  1,-4,1
  -1,3,3
  nan,nan,nan
  $ columns imap 12-19
  imap
  1,0,2,1,3,2,4,3
  -4,0,1,1,-1,2,4,3
  nan,0,3,1,-1,2,nan,3
  nan,0,nan,1,nan,2,nan,3
  $ columns 'zipWith and generate' 20-23
  zipWith and generate
  0,2,6,12
  -0,1,-2,12
  nan,3,-2,nan
  nan,nan,nan,nan
  $ columns 'replace and map, length' 24-28
  replace and map, length
  -1,0,-3,-4,4
  4,0,1,-4,4
  nan,0,1,nan,4
  nan,0,nan,nan,4
