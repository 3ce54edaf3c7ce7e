Arrays of arrays: each number has a column; functions and signal functions run
over each array.

  $ cat > grid.frob <<'FROB'
  > type Grid = Array 2 (Array 3 Float)
  > 
  > transpose :: Array n (Array m a) -> Array m (Array n a)
  > transpose rows = generate (\j -> map (\row -> at j (row ! 0) row) rows)
  > 
  > main :: SF Grid (Array 3 (Array 2 Float), Float, Array 2 Float, Grid, Bool)
  > main = proc g -> (transpose g, largest, map (foldl (+) 0) g, mapSF (mapSF (delay 9)) g, g < before) where
  >     largest = foldl max 0 (map (foldl max 0) g)
  >     before = delay [[0, 0, 0], [0, 0, 0]] g
  > FROB
  $ cat > in.csv <<'CSV'
  > time,in[0][0],in[0][1],in[0][2],in[1][0],in[1][1],in[1][2]
  > 0,1,2,3,4,5,6
  > 1,1,2,2,7,8,9
  > 2,1,2,2,7,8,9
  > CSV
  $ frobc trace grid.frob --input in.csv | tee c.csv
  time,out.1[0][0],out.1[0][1],out.1[1][0],out.1[1][1],out.1[2][0],out.1[2][1],out.2,out.3[0],out.3[1],out.4[0][0],out.4[0][1],out.4[0][2],out.4[1][0],out.4[1][1],out.4[1][2],out.5
  0.000000000,1,4,2,5,3,6,6,6,15,9,9,9,9,9,9,false
  1.000000000,1,7,2,8,2,9,9,5,24,1,2,3,4,5,6,true
  2.000000000,1,7,2,8,2,9,9,5,24,1,2,2,7,8,9,false
  $ frobc trace grid.frob --input in.csv --engine interp | cmp - c.csv
