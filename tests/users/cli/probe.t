`--probe` shows inner signals of a program, each in a column after its output.

  $ cat > lap.frob <<'EOF'
  > data Gear = Low | High Velocity
  > 
  > way :: Float -> SF Velocity Distance
  > way k = proc v -> x where
  >     x = integral (k * v)
  >     _gear = if v > 1[m/s] then High v else Low
  > 
  > main :: SF Velocity Distance
  > main = proc v -> a + b where
  >     a = way 1 v
  >     b = way 2 v
  >     over = edge (a > 2[m])
  >     _laps = onEvent (proc _ -> n where n = delay 1 (n + 1)) over
  > EOF
  $ cat > in.csv <<EOF
  > time,in
  > 0,2
  > 1,0.5
  > 2,1
  > 3,2
  > EOF
  $ frobc trace lap.frob --input in.csv > plain.csv
  $ frobc trace lap.frob --input in.csv --probe all
  time,out,probe.main.a,probe.main.b,probe.main.over,probe.main._laps,probe.way.1.k,probe.way.1.x,probe.way.1._gear,probe.way.2.k,probe.way.2.x,probe.way.2._gear,probe.edge.b,probe.edgeFrom.before,probe.edgeFrom.b,probe._laps.n
  0.000000000,0,0,0,,,1,0,High 2,2,0,High 2,false,true,false,
  1.000000000,6,2,4,,,1,2,Low,2,4,Low,false,true,false,
  2.000000000,7.5,2.5,5,(),1,1,2.5,Low,2,5,Low,true,true,true,1
  3.000000000,10.5,3.5,7,,,1,3.5,High 2,2,7,High 2,true,true,true,
  $ frobc trace lap.frob --probe list
  main.a          :: Float[m]     lap.frob:10
  main.b          :: Float[m]     lap.frob:11
  main.over       :: Event ()     lap.frob:12
  main._laps      :: Event Float  lap.frob:13
  way.1.k         :: Float        lap.frob:4
  way.1.x         :: Float[m]     lap.frob:5
  way.1._gear     :: Gear         lap.frob:6
  way.2.k         :: Float        lap.frob:4
  way.2.x         :: Float[m]     lap.frob:5
  way.2._gear     :: Gear         lap.frob:6
  edge.b          :: Bool         Prelude.frob:373
  edgeFrom.before :: Bool         Prelude.frob:382
  edgeFrom.b      :: Bool         Prelude.frob:382
  _laps.n         :: Float        lap.frob:13

A name is the end of the path to a signal, or to an instance; numbers may be omitted.

  $ columns() { frobc trace lap.frob --input in.csv --probe "$@" | head -1; }
  $ columns a
  time,out,probe.main.a
  $ columns way.x
  time,out,probe.way.1.x,probe.way.2.x
  $ columns way.2.x,main.a --probe n
  time,out,probe.main.a,probe.way.2.x,probe._laps.n
  $ columns way.1
  time,out,probe.way.1.k,probe.way.1.x,probe.way.1._gear
  $ columns probe.way.1.x
  time,out,probe.way.1.x

Other names are errors, and so is a name that matches nothing.

  $ columns way.y
  error[E0506]: this program has no inner signal `way.y`
   --> lap.frob:9:1
    |
  9 | main = proc v -> a + b where
    | ^^^^
    |
    = hint: did you mean `way.k`?
    = hint: `--probe list` lists all inner signals
  
  1 error
  $ columns wai.1.x
  error[E0506]: this program has no inner signal `wai.1.x`
   --> lap.frob:9:1
    |
  9 | main = proc v -> a + b where
    | ^^^^
    |
    = hint: did you mean `way.1.x`?
    = hint: `--probe list` lists all inner signals
  
  1 error
  $ columns w
  error[E0506]: this program has no inner signal `w`
   --> lap.frob:9:1
    |
  9 | main = proc v -> a + b where
    | ^^^^
    |
    = hint: `--probe list` lists all inner signals
  
  1 error
  $ frobc trace lap.frob
  error: the input is missing: give a recording with `--input IN.csv`
  [2]

The signals inside a function for any unit have the unit of each use, also if another definition
names the use, or if the function is an argument.

  $ cat > units.frob << 'FROB'
  > import Control
  > smooth :: SF Float[u] Float[u]
  > smooth = lowPass 1[s]
  > main :: SF (Distance, Velocity) (Distance, Velocity)
  > main = proc (x, v) -> (smooth x, smoothTwice v)
  > smoothTwice :: SF Velocity Velocity
  > smoothTwice = smooth >>> rateLimit 1[m/s^2]
  > FROB
  $ frobc trace units.frob --probe list | awk '/lowPass.y |rateLimit.y / { print $1, $3 }'
  main.lowPass.y Float[m]
  rateLimit.y Float[m/s]
  >>>.lowPass.y Float[m/s]

The program's outputs do not change, and a recording with probes can be
replayed.

  $ frobc trace lap.frob --input in.csv --probe all --output all.csv && cut -d, -f1-2 all.csv | cmp - plain.csv
  $ cut -d, -f2- all.csv | paste -d, in.csv - > recorded.csv
  $ frobc trace lap.frob --input recorded.csv | cmp - plain.csv

Without `--probe` the C code contains nothing of it.

  $ frobc compile lap.frob && grep -ic probe lap.c lap.h
  lap.c:0
  lap.h:0
  [1]

In modes, signals that do not run have empty cells; `mode` is the running mode.

  $ cat > modes.frob <<'EOF'
  > drive :: Velocity -> SF Distance (Velocity, Event Distance)
  > drive v = proc goal -> (v, tag (when (near > 0.5)) goal) where
  >     near = integral (v / goal)
  > 
  > to, fro :: SF Distance Velocity
  > to = switch (drive 1[m/s]) (\_ -> fro)
  > fro = switch (drive (-1[m/s])) (\_ -> to)
  > 
  > main :: SF Distance (Velocity, Array 2 Velocity)
  > main = proc goal -> (v, both) where
  >     v = to goal
  >     both = mapSF to [goal, 2 * goal]
  > EOF
  $ printf 'time,in\n0,1\n0.3,1\n0.6,1\n0.9,1\n1.2,1\n' > goal.csv
  $ frobc trace modes.frob --probe list
  main.v              :: Float[m/s]          modes.frob:11
  main.both           :: Array 2 Float[m/s]  modes.frob:12
  main.to.mode        :: to | fro            modes.frob:11
  main.to.v           :: Float[m/s]          modes.frob:2
  main.to.near        :: Float               modes.frob:3
  main.to.when.b      :: Bool                Prelude.frob:395
  main.to.fro.v       :: Float[m/s]          modes.frob:2
  main.to.fro.near    :: Float               modes.frob:3
  main.to.fro.when.b  :: Bool                Prelude.frob:395
  mapSF.v             :: Float[m/s]          modes.frob:2
  mapSF.to.mode       :: to | fro            modes.frob:11
  mapSF.to.v          :: Float[m/s]          modes.frob:2
  mapSF.to.goal       :: Float               modes.frob:11
  mapSF.to.near       :: Float               modes.frob:3
  mapSF.to.when.b     :: Bool                Prelude.frob:395
  mapSF.to.fro.v      :: Float[m/s]          modes.frob:2
  mapSF.to.fro.goal   :: Float               modes.frob:11
  mapSF.to.fro.near   :: Float               modes.frob:3
  mapSF.to.fro.when.b :: Bool                Prelude.frob:395
  $ frobc trace modes.frob --input goal.csv --probe main.to
  time,out.1,out.2[0],out.2[1],probe.main.to.mode,probe.main.to.v,probe.main.to.near
  0.000000000,1,1,1,to,1,0
  0.300000000,1,1,1,to,1,0.29999999999999999
  0.600000000,-1,-1,1,fro,,
  0.900000000,-1,-1,1,fro,,
  1.200000000,-1,-1,-1,fro,,
  $ frobc trace modes.frob --input goal.csv --probe mapSF.to
  time,out.1,out.2[0],out.2[1],probe.mapSF.to.mode[0],probe.mapSF.to.mode[1],probe.mapSF.to.v[0],probe.mapSF.to.v[1],probe.mapSF.to.goal[0],probe.mapSF.to.goal[1],probe.mapSF.to.near[0],probe.mapSF.to.near[1]
  0.000000000,1,1,1,to,to,1,1,1,2,0,0
  0.300000000,1,1,1,to,to,1,1,1,2,0.29999999999999999,0.14999999999999999
  0.600000000,-1,-1,1,fro,to,,1,,2,,0.29999999999999999
  0.900000000,-1,-1,1,fro,to,,1,,2,,0.44999999999999996
  1.200000000,-1,-1,-1,fro,fro,,,,,,

A probe that would make a switch depend on its own output is omitted, and is an error if it was
requested by name.

  $ cat > fed.frob <<'EOF'
  > main :: SF () Float
  > main = proc _ -> v where
  >     v = switch (proc x -> (integral (x / 1[s]), never ())) (\_ -> constant 0) v
  > 
  > constant :: Float -> SF Float Float
  > constant c = proc _ -> c
  > EOF
  $ printf 'time\n0\n1\n' > nothing.csv
  $ frobc trace fed.frob --input nothing.csv --probe all
  time,out,probe.main.v,probe.main.main.mode,probe.constant.c
  0.000000000,0,0,main,
  1.000000000,0,0,main,
  $ frobc trace fed.frob --input nothing.csv --probe x
  error[E0506]: `main.main.x` cannot be shown
   --> fed.frob:2:1
    |
  2 | main = proc _ -> v where
    | ^^^^
    |
    = note: it is inside a switch whose output is fed back to it, and showing an inner signal would make all outputs of the switch depend on that signal
  
  1 error
  [2]

The interpreter does not support probes.

  $ frobc trace lap.frob --input in.csv --probe all --engine interp
  error: only the compiled program has probes: use `--probe` with `--engine c`
  [2]

`--picture` draws the columns, with one panel for each unit.

  $ frobc trace lap.frob --input in.csv --probe x,over,_gear --picture lap.svg
  $ grep -o '>[^<>]*</text>' lap.svg
  >out</text>
  >probe.way.1.x</text>
  >probe.way.2.x</text>
  >0</text>
  >5</text>
  >10</text>
  >m</text>
  >probe.main.over</text>
  >()</text>
  >probe.way.1._gear</text>
  >High 2</text>
  >Low</text>
  >probe.way.2._gear</text>
  >High 2</text>
  >Low</text>
  >0</text>
  >0.5</text>
  >1</text>
  >1.5</text>
  >2</text>
  >2.5</text>
  >3</text>
  >time in s</text>
  $ frobc trace lap.frob --input in.csv --picture lap.png
  error: a trace is drawn as SVG: use a file name that ends in .svg, not lap.png
  [2]
