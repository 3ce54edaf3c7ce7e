`frobc report --states` shows the machines of a program for Graphviz: machines that run inside a
state, and transitions that depend on the outside.

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
  $ frobc report bug.frob --states
  digraph "bug" {
    node [shape=box, style=rounded];
    subgraph cluster0 {
      label="circle, bug.frob:11";
      start0 [shape=point];
      state0_0 [label="sleepT\nline 11"];
      state0_1 [label="circle\nline 12"];
      state0_2 [label="ended\nline 12"];
      start0 -> state0_0;
      state0_0 -> state0_1 [label="elapsed"];
      state0_1 -> state0_2 [label="edge"];
    }
    subgraph cluster1 {
      label="main, bug.frob:21";
      start1 [shape=point];
      state1_0 [label="driveTo\nline 2"];
      state1_1 [label="timeOut\nline 7"];
      state1_2 [label="ended\nline 17"];
      state1_3 [label="sleepT\nline 8"];
      start1 -> state1_0;
      state1_0 -> state1_2 [label="edge"];
      state1_0 -> state1_1 [label="edge"];
      state1_1 -> state1_3 [label="elapsed"];
      state1_3 -> state1_0 [label="elapsed"];
    }
    state1_1 -> start0 [style=dotted, arrowhead=none];
  }

  $ cat > outside.frob <<'EOF'
  > main :: SF (Float, Event Float) Float
  > main = proc (x, e) -> rSwitch (constant 0) (x, mapE ramp e) where
  >     ramp k = dSwitch (proc y -> (k * y, edge (y > 2))) (\_ -> constant 1)
  > EOF
  $ frobc report outside.frob --states | without_lines
  digraph "outside" {
    node [shape=box, style=rounded];
    subgraph cluster0 {
      label="main, outside.frob:2";
      start0 [shape=point];
      state0_0 [label="constant\nPrelude.frob"];
      state0_1 [label="ramp\nline 3"];
      start0 -> state0_0;
      any0 [label=any, shape=plaintext];
      any0 -> state0_1;
      state0_1 -> state0_0 [label="edge", arrowhead=onormal];
    }
  }

The report states how many states can follow each other within an instant.

  $ frobc report bug.frob | sed -n '/^modes/,$p' | without_lines
  modes
    main, bug.frob:21: 4 modes (driveTo, timeOut, ended, sleepT); maximum number of steps within one instant: 2
    circle, bug.frob:11: 3 modes (sleepT, circle, ended); maximum number of steps within one instant: 2
  
  switching events in the first instant of their mode
    from driveTo to ended      cannot occur: `edge`     bug.frob:2
    from driveTo to timeOut    cannot occur: `edge`     bug.frob:2
    from timeOut to sleepT     cannot occur: `elapsed`  Prelude.frob
    from sleepT to driveTo     cannot occur: `elapsed`  Prelude.frob
    from sleepT to circle      cannot occur: `elapsed`  Prelude.frob
    from circle to ended       cannot occur: `edge`     bug.frob:12
