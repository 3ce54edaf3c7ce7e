frobc searches for a world by its name in the current folder, next to the program, and among the
worlds that come with frobc, in this order; for a trial, next to the program, and among those
worlds.

  $ mkdir prog folder
  $ cat > prog/ahead.frob << 'FROB'
  > import Robot
  > import Trial
  > main :: DiffDrive o => Program i o
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0.1[m/s] 0))
  > trial "own" = Trial { world = "room.toml", lasts = 1[s], seeds = 1 `to` 1, judge = neverTouches }
  > trial "near" = Trial { world = "near.toml", lasts = 1[s], seeds = 1 `to` 1, judge = neverTouches }
  > trial "none" = Trial { world = "none.toml", lasts = 1[s], seeds = 1 `to` 1, judge = neverTouches }
  > trial "folder" = Trial { world = "../folder", lasts = 1[s], seeds = 1 `to` 1, judge = neverTouches }
  > FROB
  $ printf '[start]\nx = 0\ny = 0\n' > prog/near.toml
  $ run () { frobc run prog/ahead.frob --robot pioneer --for 1s --world "$1" | head -n 1; }
  $ run room.toml
  time simulated: 1.000 s
  $ run near.toml
  time simulated: 1.000 s
  $ run prog/near.toml
  time simulated: 1.000 s

A missing world and an unreadable one have different messages.

  $ run none.toml
  error: there is no world `none.toml` here or next to prog/ahead.frob or among the worlds that come with frobc: room.toml
  $ run folder
  error: cannot read the world `folder`: Is a directory
  $ run $PWD/none.toml | sed "s|$PWD|PWD|"
  error: there is no world `$TESTCASE_ROOT/none.toml`
  $ frobc test prog/ahead.frob --robot pioneer
  ok    own: 1 seed, 1 s
  ok    near: 1 seed, 1 s
  FAIL  none: there is no world `none.toml` next to prog/ahead.frob or among the worlds that come with frobc: room.toml
  FAIL  folder: cannot read the world `prog/../folder`: Is a directory
  4 tests: 2 failed
  [1]
