Mistakes in a plan are reported before the first run, with their places.

  $ cat > follow.frob << 'FROB'
  > import Robot
  > import Trial
  > import WallFollow
  > param gap :: Distance = 0.3[m]
  > param on :: Bool = True
  > main :: (HasSonar i, DiffDrive o) => Program i o
  > main = reactimateRobot (wallFollow1 gap)
  > trial "keeps off" = Trial { world = "room.toml", lasts = 5[s], seeds = 1 `to` 60, judge = neverTouches }
  > FROB
  $ try () { cat > plan.toml; frobc sweep plan.toml "$@"; }
  $ try << 'PLAN'
  > programm = "follow.frob"
  > seeds = [20, 1]
  > worlds = "x"
  > lasts = -1
  > sampling = "latn"
  > [params]
  > gap = "1 to 2"
  > b = "1 to 2, x steps"
  > c = []
  > d = "1 to 2, 1 steps"
  > PLAN
  error: plan.toml:1:1: unknown key `programm`; did you mean `program`?
  error: plan.toml:2:9: the last seed is less than the first; write [1, 20]
  error: plan.toml:3:10: `worlds` must be a list of strings, such as ["a", "b"]
  error: plan.toml:4:9: `lasts` must be more than zero
  error: plan.toml:5:12: `sampling` must be "grid", "random" or "latin"
  error: plan.toml:7:7: the number of steps is missing: write a range as "LOW to HIGH, N steps", such as "2[1/m] to 8[1/m], 7 steps"; with `sampling`, write "LOW to HIGH"
  error: plan.toml:8:5: write a range as "LOW to HIGH, N steps", such as "2[1/m] to 8[1/m], 7 steps"; with `sampling`, write "LOW to HIGH"
  error: plan.toml:9:5: this list is empty: add a value
  error: plan.toml:10:5: the number of steps must be from 2 (the two ends) to 10,000,000
  [2]
  $ try << 'PLAN'
  > program =
  > PLAN
  error: plan.toml:1:10: a value is missing after the `=`
  [2]
  $ try << 'PLAN'
  > program = "follow.frob"
  > sampling = "latin"
  > PLAN
  error: plan.toml:2:12: `sampling = "latin"` needs the number of points: add the key `points`
  [2]
  $ plan () { printf 'program = "follow.frob"\nrobots = ["pioneer"]\n%b\n' "$1" | try; }
  $ plan '[params]\ngap = "0.5[m] to 0.2[m], 3 steps"'
  error: plan.toml:4:7: the range of `gap` ends at 0.2, which is not greater than its start, 0.5
  [2]
  $ plan '[params]\ngap = "0.2[s] to 0.5[m], 3 steps"'
  error: plan.toml:4:7: this is not a value of the parameter `gap`
  error[E0320]: expected the unit `m`, found `s`
   --> --param gap:1:6
    |
  1 | gap= 0.2[s]
    |      ^^^^^^ this is `Float[s]`
    |
   ::: follow.frob:4:14
    |
  4 | param gap :: Distance = 0.3[m]
    |              -------- the signature of `gap` requires `Distance` (m)
    |
    = hint: write `0.2[m]` if you meant that unit
    = hint: if this is the right result, write the signature as `gap :: Float[s]`
  
  1 error
  [2]
  $ plan '[params]\ngp = 3'
  error: plan.toml:4:6: this is not a value of the parameter `gp`
  error[E0507]: the program has no parameter `gp`
   --> --param gp:1:1
    |
  1 | gp= 3
    | ^
    |
    = note: the program's parameters: `gap` and `on`
    = hint: did you mean `gap`?
  
  1 error
  [2]
  $ plan '[params]\non = "False to True, 2 steps"'
  error: plan.toml:4:6: `on` is a Bool and has no range: write the list [true, false]
  [2]
  $ plan '[params]\ngap = "0 to 1/0, 2 steps"'
  error: plan.toml:4:7: the range of `gap` must be finite
  [2]
  $ plan 'worlds = ["room.toml", "rome.toml"]'
  error: plan.toml:3:24: there is no world `rome.toml` next to follow.frob or among the worlds that come with frobc: room.toml
  [2]
  $ printf '[start]\nx = 0\ny = 0\nspeed = 1\n' > odd.toml
  $ plan 'worlds = ["odd.toml"]'
  error: odd.toml:4:1: unknown key `speed`
  [2]
  $ printf '[start]\nx = 0\ny = 0\n[[circle]]\ncenter = [0, 0]\nradius = 1\n' > inside.toml
  $ plan 'worlds = ["room.toml", "inside.toml"]'
  error: inside.toml:1:1: the robot starts inside a wall or another object
  [2]
  $ plan 'trial = "keeps"'
  error: plan.toml:3:9: follow.frob has no trial `keeps`; it has `keeps off`
  [2]
  $ plan 'seeds = [1, 900000000]'
  error: plan.toml: this plan has 900000000 runs, but a sweep can have at most 10000000: use fewer steps or seeds
  [2]
  $ printf 'program = "no.frob"\n' | try
  error: plan.toml:1:11: there is no file no.frob
  [2]
  $ printf 'program = "follow.frob"\n' | try
  error[E0502]: the type of `main` does not say which robot it runs on
   --> follow.frob:7:1
    |
  7 | main = reactimateRobot (wallFollow1 gap)
    | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |
    = hint: `pioneer`, `scout`, `create` and `ros` have everything that the program needs: compile it with `--robot pioneer`, `--robot scout`, `--robot create` or `--robot ros`
  
  1 error
  [1]
  $ printf 'program = "follow.frob"\nrobots = ["rover"]\n' | try
  error: plan.toml:2:11: there is no robot `rover`; the robots are pioneer, scout, create, ros; for your own robot, give the file of its module
  [2]
  $ printf 'program = "follow.frob"\nrobots = ["pioneer"]\n' | try --robot scout
  error: plan.toml:2:11: remove `robots` here, or the option --robot
  [2]
  $ sed '/^trial/d' follow.frob > bare.frob
  $ printf 'program = "bare.frob"\n' | try --robot pioneer
  warning[W0306]: `Trial` is imported, but nothing from it is used
   --> bare.frob:2:1
    |
  2 | import Trial
    | ^^^^^^^^^^^^
    |
    = hint: remove it
  
  1 warning
  error: plan.toml:1:11: bare.frob has no trial, but a sweep needs one to judge and measure the runs: write `trial "…" = Trial { … }`
  [2]
  $ frobc sweep none.toml
  error: there is no file none.toml
  [2]
  $ frobc sweep plan.toml --shard 3/2
  frobc: option '--shard': `3/2` is not a shard; for the third of a hundred
         shards, write 3/100
  Usage: frobc sweep [OPTION]… PLAN.toml
  Try 'frobc sweep --help' or 'frobc --help' for more information.
  [2]
  $ frobc sweep plan.toml --picture p.png
  error: p.png must end in .svg: a sweep is drawn as SVG
  [2]
  $ echo "notes" > plan.csv; printf 'program = "follow.frob"\nlasts = 0.1\nseeds = [1, 1]\n' | try --robot pioneer
  error: --table would overwrite plan.csv, which is an existing file, but not the table of a sweep: move it away, or use another file name
  [2]
  $ ls -I '*.t'
  bare.frob
  follow.frob
  inside.toml
  odd.toml
  plan.csv
  plan.toml
