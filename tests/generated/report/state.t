The report shows the state struct by struct, with the source of each member, and
the padding that a C compiler for a 64-bit machine inserts between and after
them.

  $ cat > smooth.frob <<EOF
  > main :: SF Float (Float, Bool)
  > main = proc x -> (smooth (smooth x), delay False (x > 1))
  > 
  > smooth :: SF Float Float
  > smooth = proc x -> y where
  >   y = 0.5 * delay 0 y + 0.5 * delay 1 x
  > EOF
  $ frobc report smooth.frob | sed '/^$/,$d'
  state, in bytes
    main               40         smooth.frob:2
      y_prev            8  delay  smooth.frob:6
      x_prev            8  delay  smooth.frob:6
      smooth_2.y_prev   8  delay  smooth.frob:6
      y_prev            8  delay  smooth.frob:6
      delay             1  delay  smooth.frob:2
      (padding)         7

Modes share memory, which has the size of the largest mode.

  $ cat > modes.frob <<EOF
  > main :: SF Float Float
  > main = near
  > 
  > near :: SF Float Float
  > near = switch (proc x -> (delay 0 x, when (x > 5))) (\_ -> far 1)
  > 
  > far :: Float -> SF Float Float
  > far k = switch (proc x -> (k * delay 0 (delay 0 x), edge (x < 4))) (\_ -> near)
  > EOF
  $ frobc report modes.frob | sed '/^$/,$d; s/Prelude.frob:.*/Prelude.frob/'
  state, in bytes
    main          24                                modes.frob:2
      modes       16  memory shared by these modes  modes.frob:2
        near       8  mode                          modes.frob:5
          x_prev   8  delay                         modes.frob:5
        far       16  mode                          modes.frob:8
          x_prev   8  delay                         modes.frob:8
          delay    8  delay                         modes.frob:8
      mode         1  number of the active mode     modes.frob:2
      modes        1  memory shared by these modes  modes.frob:2
        far        1  mode                          modes.frob:8
          delay    1  delay                         Prelude.frob
      (padding)    6
  $ frobc report modes.frob | sed -n '/^modes/,$p'
  modes
    main, modes.frob:2: 2 modes (near, far); maximum number of steps within one instant: 3
  
  switching events in the first instant of their mode
    from near to far    may occur             modes.frob:5
    from far to near    cannot occur: `edge`  modes.frob:8

Each struct is shown once, so the report about a million instances is short.

  $ cat > million.frob <<EOF
  > f0 :: SF Float Float
  > f0 = delay 0
  > EOF
  $ for n in $(seq 1 20); do echo "f$n = f$((n - 1)) >>> f$((n - 1))" >> million.frob; done
  $ echo 'main = f20' >> million.frob
  $ frobc report million.frob | sed '/^$/,$d; s/Prelude.frob:.*/Prelude.frob/' | head -5
  state, in bytes
    >>>                          8388608                 Prelude.frob
      >>>.>>>                    2097152  >>>            Prelude.frob
        >>>.>>>                   524288  >>>            Prelude.frob
          >>>.>>>                 131072  >>>            Prelude.frob
  $ frobc report million.frob | wc -l
  63

A program without state has a state of one byte, because C has no empty structs:

  $ cat > twice.frob <<EOF
  > main :: SF Float Float
  > main = proc x -> 2 * x
  > EOF
  $ frobc report twice.frob
  state, in bytes
    main         1    twice.frob:2
      (padding)  1
  
  operations of a step, at most
    additions                0
    multiplications          1
    divisions                0
    comparisons and choices  0
    conversions              0
    loads of state           0
    stores of state          0
  
  stack, in bytes, at most
    reset  48  main
    step   88  main
