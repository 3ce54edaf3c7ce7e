Parameters are numbers that are fixed when a run starts.

  $ cat > steer.frob <<'END'
  > -- | The turn for each metre,
  > -- to the left.
  > param kTurn :: Float[1/m] = 2 * half
  > param most :: Int = 3
  > param on :: Bool = True
  > 
  > half :: Float[1/m]
  > half = 2[1/m]
  > 
  > main :: SF (Distance, Int) (Float, Bool)
  > main = proc (x, n) -> (kTurn * x, on && n < most)
  > END
  $ printf 'time,in.1,in.2\n0,1,2\n1,2,4\n' > in.csv
  $ frobc trace steer.frob --input in.csv
  time,out.1,out.2
  0.000000000,4,true
  1.000000000,8,false

An option sets them, and both engines agree.

  $ for engine in c interp; do
  >   frobc trace steer.frob --input in.csv --engine $engine --param 'kTurn=1/20[cm]' --param most=10
  >   frobc trace steer.frob --input in.csv --engine $engine --real float --param on=false --param 'kTurn=-1[1/m]' | tail -1
  > done
  time,out.1,out.2
  0.000000000,5,true
  1.000000000,10,true
  1.000000000,-2,false
  time,out.1,out.2
  0.000000000,5,true
  1.000000000,10,true
  1.000000000,-2,false

The header declares them as a struct; the C works for any values.

  $ frobc compile steer.frob && sed -n '/^\/\* Param/,/^extern/p' steer.h
  /* Parameters. Do not change them between a reset and the last step after it. */
  struct steer_params {
      /* The turn for each metre,
       * to the left. [1/m] */
      double kTurn;
      int32_t most;
      bool on;
  };
  
  extern const struct steer_params steer_default_params;
  $ grep 'params->' steer.c
      out->f1 = params->kTurn * x;                            /* line 11 */
      out->f2 = params->on && n < params->most;

A replay uses the values of the recording, unless an option sets others.

  $ (printf '# param kTurn=7[1/m]\n# param gone=1\n'; cat in.csv) > recorded.csv
  $ for engine in c interp; do
  >   frobc trace steer.frob --input recorded.csv --engine $engine | tail -1
  >   frobc trace steer.frob --input recorded.csv --engine $engine --param 'kTurn=1[1/m]' | tail -1
  > done
  warning: recorded.csv: the program has no parameter `gone`; the program has `kTurn`, `most`, `on`
  1.000000000,14,false
  warning: recorded.csv: the parameter `kTurn` is 1[1/m], as set by the option, but it was 7[1/m] in the recording
  warning: recorded.csv: the program has no parameter `gone`; the program has `kTurn`, `most`, `on`
  1.000000000,2,false
  warning: recorded.csv: the program has no parameter `gone`; the program has `kTurn`, `most`, `on`
  1.000000000,14,false
  warning: recorded.csv: the parameter `kTurn` is 1[1/m], as set by the option, but it was 7[1/m] in the recording
  warning: recorded.csv: the program has no parameter `gone`; the program has `kTurn`, `most`, `on`
  1.000000000,2,false
  $ (echo '# param kTurn=7[m]'; cat in.csv) > other.csv
  $ for engine in c interp; do frobc trace steer.frob --input other.csv --engine $engine; done
  error: other.csv: the parameter `kTurn` is a number in 1/m, but `7[m]` has a different unit; to override the recorded value, use `--param`
  error: other.csv: the parameter `kTurn` is a number in 1/m, but `7[m]` has a different unit; to override the recorded value, use `--param`
  [2]

Mistakes in options.

  $ frobc trace steer.frob --input in.csv --param kTurn=5
  error[E0320]: expected the unit `1/m`, found none
   --> --param kTurn:1:8
    |
  1 | kTurn= 5
    |        ^ this is `Float`
    |
   ::: steer.frob:3:16
    |
  3 | param kTurn :: Float[1/m] = 2 * half
    |                ---------- the signature of `kTurn` requires `Float[1/m]`
    |
    = hint: write `5[1/m]` if that is the right unit
  
  1 error
  [2]
  $ frobc trace steer.frob --input in.csv --param 'kTrun=5[1/m]'
  error[E0507]: the program has no parameter `kTrun`
   --> --param kTrun:1:1
    |
  1 | kTrun= 5[1/m]
    | ^
    |
    = note: the program's parameters: `kTurn`, `most` and `on`
    = hint: did you mean `kTurn`?
  
  1 error
  [2]
  $ frobc trace steer.frob --input in.csv --param kTurn
  error: --param takes NAME=VALUE, as in `kTurn=4[1/m]`, not `kTurn`
  [2]
  $ frobc trace steer.frob --input in.csv --param 'kTurn=0/0*half'
  error[E0391]: the value of the parameter `kTurn` is not a number
   --> --param kTurn:1:8
    |
  1 | kTurn= 0/0*half
    |        ^^^^^^^^
    |
    = note: it is NaN, like `0 / 0`
  
  1 error
  [2]

Mistakes in declarations.

  $ cat > wrong.frob <<'END'
  > param pair :: (Int, Int) = (1, 2)
  > param any :: Float[u] = 0
  > END
  $ frobc check wrong.frob
  error[E0390]: the parameter `pair` cannot have the type `(Int, Int)`
   --> wrong.frob:1:1
    |
  1 | param pair :: (Int, Int) = (1, 2)
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: a parameter must be a number or a `Bool`, so that the command line can set it
    = hint: declare a separate parameter for each number in this value; for a choice, use a `Bool` or an `Int`
  
  error[E0390]: the parameter `any` cannot have the polymorphic type `Float[u]`
   --> wrong.frob:2:1
    |
  2 | param any :: Float[u] = 0
    | ^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: a parameter must be a number or a `Bool`, so that the command line can set it
    = hint: name its unit, as in `Float[1/m]`
  
  2 errors
  [1]
  $ cat > index.frob <<'END'
  > param k :: Int = 1
  > param l :: Int = k + 1
  > 
  > main :: SF (Array 3 Float) Float
  > main = proc xs -> xs ! k
  > END
  $ frobc check index.frob
  error[E0347]: the index of `!` must be constant, but the parameter `k` is only known when the program starts
   --> index.frob:5:24
    |
  5 | main = proc xs -> xs ! k
    |                        ^
    |
    = note: an index can be a number, the name of a constant, or arithmetic on these
    = hint: use `at k 0 xs`, which takes any index and returns `0` if there is no such element
  
  1 error
  [1]
  $ echo 'param k = 1' > untyped.frob
  $ frobc check untyped.frob
  error[E0110]: a parameter needs a type before its value
   --> untyped.frob:1:9
    |
  1 | param k = 1
    |         ^
    |
    = hint: write `param k :: Float = 1`
  
  1 error
  [1]

A run records the parameters, may overwrite its own recording, and is replayed
with the same values.

  $ cat > stop.frob <<'END'
  > import Robot
  > 
  > param near :: Distance = 0.5[m]
  > 
  > main :: Program RobotInput RobotOutput
  > main = reactimateRobot (proc i -> roMake (setVelTR (if frontSonar i < near then 0 else 0.3[m/s]) 0))
  > END
  $ frobc run stop.frob --for 1s --record run.csv > summary
  $ frobc run stop.frob --for 8s --record run.csv --param near=0.9[m] > summary
  $ head -1 run.csv
  # param near=0.9[m]
  $ for engine in c interp; do frobc trace stop.frob --input run.csv --engine $engine > $engine.csv; done
  $ cmp c.csv interp.csv
  $ columns() { sed '/^#/d' "$1" | awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) if ($k ~ /^out/) at[++n] = k } { line = ""; for (k = 1; k <= n; k++) line = line "," $at[k]; print line }'; }
  $ columns run.csv > recorded; columns c.csv | diff recorded - && tail -1 recorded
  ,0.29999999999999999,0
