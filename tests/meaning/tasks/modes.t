`trace --modes` shows which mode of each machine runs after an instant; the cell is empty for a
machine in a mode that does not run.

  $ . ./trace.sh
  $ cat > bug.frob <<'EOF'
  > driveTo :: Float -> Task Float Float Bool
  > driveTo goal = mkTask (proc x -> (1, mergeE (tag (edge (x > goal)) True) (tag (edge (x < 0)) False)))
  > 
  > goAround, circle :: Float -> Task Float Float ()
  > goAround _ = do
  >     start <- snapT
  >     mapT (const ()) (circle start `timeOut` 20[s])
  >     sleepT 0.5[s] 0
  > 
  > circle v = do
  >     sleepT 1[s] v
  >     mkTask (proc x -> (2 * v, edge (x > 3)))
  > 
  > bug :: Float -> Task Float Float ()
  > bug goal = do
  >     arrived <- driveTo goal
  >     if arrived then return () else do
  >         goAround goal
  >         bug goal
  > 
  > main = runTask (bug 10)
  > EOF
  $ printf '%s\n' 0 5 -1 0 0 0 4 4 4 4 | rows in > bug.csv
  $ frobc trace --modes bug.frob --input bug.csv | tee modes.csv
  time,out,mode.main,mode.circle
  0.000000000,Left 1,driveTo,
  0.500000000,Left 1,driveTo,
  1.000000000,Left (-1),timeOut,sleepT
  1.500000000,Left (-1),timeOut,sleepT
  2.000000000,Left (-2),timeOut,circle
  2.500000000,Left (-2),timeOut,circle
  3.000000000,Left 0,sleepT,
  3.500000000,Left 1,driveTo,
  4.000000000,Left 1,driveTo,
  4.500000000,Left 1,driveTo,

The result can be used as input again: modes are outputs.

  $ sed 's/,out/,in/; s/Left //' modes.csv | cut -d, -f1,2,3 > again.csv
  $ frobc trace bug.frob --input again.csv | head -2
  time,out
  0.000000000,Left 1

One machine for each element of an array, duplicate names, switches inside tasks, and no machine at
all.

  $ cat > many.frob <<'EOF'
  > main :: SF (Array 2 Float, Float) (Array 2 (Either Float ()), Either Float ())
  > main = proc (xs, y) -> (mapSF (runTask seesaw) xs, runTask (forever phases) y)
  > 
  > phases :: Task Float Float (Maybe ())
  > phases = do
  >     sleepT 0.5[s] 1
  >     sleepT 0.5[s] 2
  >     mkTask (switch (constant 3 &&& now ()) (\_ -> constant 4) &&& never) `timeOut` 0.5[s]
  > 
  > seesaw :: Task Float Float ()
  > seesaw = do
  >     mkTask (proc x -> (x, edge (x > 1)))
  >     mkTask (proc x -> (-x, edge (x < 0)))
  >     seesaw
  > EOF
  $ printf '%s\n' 0,0,0 2,0,0 2,2,0 -1,2,0 -1,-1,0 | rows 'in.1[0],in.1[1],in.2' > many.csv
  $ frobc trace --modes many.frob --input many.csv | cut -d, -f1,5-
  time,mode.mapSF[0],mode.mapSF[1],mode.forever,mode.phases
  0.000000000,seesaw,seesaw,sleepT,
  0.500000000,seesaw_2,seesaw,sleepT_2,
  1.000000000,seesaw_2,seesaw_2,timeOut,constant
  1.500000000,seesaw,seesaw_2,sleepT,
  2.000000000,seesaw,seesaw,sleepT_2,
  $ printf 'main :: SF Float Float\nmain = identity\n' > none.frob
  $ printf '1\n2\n' | rows in | frobc trace --modes none.frob --input -
  time,out
  0.000000000,1
  0.500000000,2

The interpreter has no modes.

  $ frobc trace --modes --engine interp none.frob --input bug.csv
  error: only the compiled program shows its modes: use `--modes` with `--engine c`
  [2]
