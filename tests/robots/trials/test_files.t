The tests and trials of a program may be in a separate file, next to it. They can use all names and
imports of the program, and may have more imports.

  $ cat > slow.frob << 'FROB'
  > import Robot
  > import Trial
  > 
  > gentle :: Velocity -> Velocity
  > gentle v = v / 2
  > 
  > main = reactimateRobot (constant (roMake (setVelTR (gentle 0.4[m/s]) 0)))
  > 
  > trial "touches nothing" = Trial { world = "room.toml", lasts = 2[s], seeds = 1 `to` 2, judge = neverTouches }
  > FROB
  $ cat > slow.test.frob << 'FROB'
  > import Past
  > import Sources (sine)
  > 
  > test "halves a speed" = during 1[s] (proc () -> gentle 0.4[m/s] == 0.2[m/s])
  > 
  > test "knows its own imports" = during 1[s] (proc () -> abs (sine 1[Hz] ()) <= 1)
  > 
  > trial "drives half a metre" = Trial { world = "room.toml", lasts = 4[s], seeds = 1 `to` 2, judge = far }
  > 
  > far = proc t -> by 4[s] (way > 0.5[m]) where
  >     way = lastOf t.driven
  > FROB
  $ frobc test slow.frob --robot pioneer | sed -E 's/[0-9.]+ m\b/N m/; s/mean.*/…/'
  ok    touches nothing: 2 seeds, 2 s
  ok    halves a speed: 1 s
  ok    knows its own imports: 1 s
  ok    drives half a metre: 2 seeds, 4 s
        way: …
  4 tests: all hold
  $ frobc test slow.test.frob --robot pioneer -k own
  ok    knows its own imports: 1 s
  1 test: all hold
  $ frobc test --robot pioneer -k a
  ok    halves a speed: 1 s
  ok    drives half a metre: 2 seeds, 4 s
        way: mean 0.7339 m, deviation 0, from 0.7339 (seed 1) to 0.7339 (seed 1)
  2 tests: all hold
  $ frobc test slow.frob slow.test.frob --robot pioneer -k halves
  ok    halves a speed: 1 s
  1 test: all hold
  $ frobc check slow.frob

The failing test is in the test file, and the command that shows it names that file; for a trial, it
names the program.

  $ cat > slow.test.frob << 'FROB'
  > test "doubles a speed" = during 1[s] (proc () -> gentle 0.4[m/s] == 0.8[m/s])
  > 
  > trial "stands still" = Trial { world = "room.toml", lasts = 1[s], seeds = 1 `to` 1, judge = still }
  > 
  > still = proc t -> atEnd (t.driven < 1[cm])
  > FROB
  $ frobc test slow.frob --robot pioneer | grep -E '^(ok|FAIL)|frobc view' | sed 's|--world /[^ ]*/|--world |'
  ok    touches nothing: 2 seeds, 2 s
  FAIL  doubles a speed: failed at 0.000 s
        frobc view failed/doubles-a-speed.csv slow.test.frob --robot pioneer --entry 'judge test doubles a speed' --at 0s
  FAIL  stands still: 1 of 1 seed; seed 1: undecided at the end, after 1 s
        frobc view failed/stands-still-1.csv slow.frob --robot pioneer --world room.toml --seed 1 --at 1s
          frobc view failed/stands-still-1-simpler.csv slow.frob --robot pioneer --world failed/stands-still-1-simpler.toml --seed 1 --at 1s
  $ frobc test slow.frob --robot pioneer --json | sed 's/,"label.*//' | sort | uniq -c | sed 's/^ *//'
  1 {"file":"slow.frob"
  2 {"file":"slow.test.frob"

A program is compiled without its test file, whatever the file contains. Neither running nor tracing
reads it.

  $ mkdir with without
  $ frobc compile slow.frob --robot pioneer -o with
  $ mv slow.test.frob away && frobc compile slow.frob --robot pioneer -o without
  $ cmp with/slow.c without/slow.c && cmp with/slow.h without/slow.h
  $ echo 'this is no program (' > slow.test.frob
  $ printf 'time\n0\n' > once.csv
  $ frobc run slow.frob --robot pioneer --for 0.1s > /dev/null
  $ frobc compile slow.frob --robot pioneer -o with
  $ frobc check slow.frob
  error[E0111]: this `(` is never closed
   --> slow.test.frob:1:20
    |
  1 | this is no program (
    |                    ^- a `)` is missing before this
  
  1 error
  [1]

A program cannot use its test file.

  $ cat > helped.frob << 'FROB'
  > main :: SF Float Float
  > main = proc x -> helper x
  > FROB
  $ echo 'helper x = 2 * x' > helped.test.frob
  $ frobc check helped.frob
  error[E0205]: unknown name `helper`
   --> helped.frob:2:18
    |
  2 | main = proc x -> helper x
    |                  ^^^^^^
  
  1 error
  [1]

A test file has no header and no `main`, and does not define names that its program defines. Places
refer to the test file.

  $ cat > slow.test.frob << 'FROB'
  > module Slow where
  > 
  > main = constant 1
  > FROB
  $ frobc check slow.frob
  error[E0237]: a test file cannot have a `module` header
   --> slow.test.frob:1:8
    |
  1 | module Slow where
    |        ^^^^
    |
    = hint: remove the header: the tests belong to the program's module
  
  error[E0237]: a test file cannot define `main`
   --> slow.test.frob:3:1
    |
  3 | main = constant 1
    | ^^^^
    |
    = hint: a program is compiled without its test file: define `main` in the program, or give this definition another name
  
  2 errors
  [1]
  $ cat > slow.test.frob << 'FROB'
  > -- the program has one
  > gentle v = v / 3
  > 
  > test "is wrong" = during 1[s] (proc () -> gentle 1[m] == unknown)
  > 
  > trial "touches nothing" = Trial { world = "room.toml", lasts = 2[s], seeds = 1 `to` 2, judge = neverTouches }
  > FROB
  $ frobc check slow.frob
  error[E0211]: the name `gentle` is defined twice
   --> slow.test.frob:2:1
    |
  2 | gentle v = v / 3
    | ^^^^^^
    |
   ::: slow.frob:5:1
    |
  5 | gentle v = v / 2
    | ------ first defined here
    |
    = hint: rename this definition: a test file shares the namespace of its program
  
  error[E0205]: unknown name `unknown`
   --> slow.test.frob:4:58
    |
  4 | test "is wrong" = during 1[s] (proc () -> gentle 1[m] == unknown)
    |                                                          ^^^^^^^
  
  error[E0211]: the name `trial touches nothing` is defined twice
   --> slow.test.frob:6:7
    |
  6 | trial "touches nothing" = Trial { world = "room.toml", lasts = 2[s], seeds = 1 `to` 2, judge = neverTouches }
    |       ^^^^^^^^^^^^^^^^^
    |
   ::: slow.frob:9:7
    |
  9 | trial "touches nothing" = Trial { world = "room.toml", lasts = 2[s], seeds = 1 `to` 2, judge = neverTouches }
    |       ----------------- first defined here
    |
    = hint: rename this definition: a test file shares the namespace of its program
  
  3 errors
  [1]

Without its program, a test file is invalid, and it cannot be run as a program.

  $ cp away lost.test.frob
  $ frobc check lost.test.frob
  error[E0236]: this is a test file, but the program `lost.frob` does not exist
   --> lost.test.frob:1:1
    |
  1 | test "doubles a speed" = during 1[s] (proc () -> gentle 0.4[m/s] == 0.8[m/s])
    | ^
    |
    = hint: put the tests of `NAME.frob` into `NAME.test.frob` in the same folder
  
  1 error
  [1]
  $ frobc test lost.test.frob
  error[E0236]: this is a test file, but the program `lost.frob` does not exist
   --> lost.test.frob:1:1
    |
  1 | test "doubles a speed" = during 1[s] (proc () -> gentle 0.4[m/s] == 0.8[m/s])
    | ^
    |
    = hint: put the tests of `NAME.frob` into `NAME.test.frob` in the same folder
  
  1 error
  [1]
  $ mkdir lost.frob && frobc check lost.test.frob; rmdir lost.frob
  error[E0236]: this is a test file, but the program `lost.frob` cannot be read: it is a directory
   --> lost.test.frob:1:1
    |
  1 | test "doubles a speed" = during 1[s] (proc () -> gentle 0.4[m/s] == 0.8[m/s])
    | ^
    |
    = hint: put the tests of `NAME.frob` into `NAME.test.frob` in the same folder
  
  1 error
  $ cp away slow.test.frob && frobc run slow.test.frob
  error[E0501]: this module has no `main` to compile
   --> slow.test.frob:1:1
    |
  1 | test "doubles a speed" = during 1[s] (proc () -> gentle 0.4[m/s] == 0.8[m/s])
    | ^
    |
    = hint: this is a test file: instead, name the program that it tests, slow.frob
  
  1 error
  [2]
  $ rm slow.test.frob && mkdir slow.test.frob && frobc check slow.frob; frobc test slow.frob
  error: cannot read slow.test.frob: it is a directory
  ok    touches nothing: 2 seeds, 2 s
  1 test: all hold
  error: cannot read slow.test.frob: it is a directory
  [2]
  $ rmdir slow.test.frob

Imports of a test file may lead back to the program, but not form a cycle.

  $ cat > Gains.frob << 'FROB'
  > gain :: Float
  > gain = 2
  > FROB
  $ cat > Twice.frob << 'FROB'
  > import Gains
  > 
  > twice :: Float -> Float
  > twice x = gain * x
  > FROB
  $ cat > Gains.test.frob << 'FROB'
  > import Trial
  > import Twice
  > 
  > test "doubles" = during 1[s] (proc () -> twice 3 == 2 * Gains.gain + gain)
  > FROB
  $ frobc test Gains.frob
  ok    doubles: 1 s
  1 test: all hold
  $ sed -i 's/^import Gains/import Gains\nimport Once/' Twice.frob
  $ cat > Once.frob << 'FROB'
  > import Twice
  > FROB
  $ frobc check Gains.frob
  error[E0202]: modules import each other: `Twice` → `Once` → `Twice`
   --> Once.frob:1:8
    |
  1 | import Twice
    |        ^^^^^
    |
   ::: Twice.frob:2:8
    |
  2 | import Once
    |        ---- `Twice` imports `Once`
  
  1 error
  [1]

An import that the program does not use is reported even if its tests use its names; if a test file
imports its own program, the message says that this is not necessary.

  $ rm Twice.frob Once.frob
  $ cat > Gains.frob << 'FROB'
  > import Sources
  > 
  > gain :: Float
  > gain = 2
  > FROB
  $ cat > Gains.test.frob << 'FROB'
  > import Gains
  > import Trial
  > 
  > test "is small" = during 1[s] (proc () -> abs (sine 1[Hz] ()) <= gain)
  > FROB
  $ frobc check Gains.frob
  warning[W0306]: `Sources` is imported, but nothing from it is used
   --> Gains.frob:1:1
    |
  1 | import Sources
    | ^^^^^^^^^^^^^^
    |
    = hint: remove it
  
  1 warning
  warning[W0306]: `Gains` is imported, but nothing from it is used
   --> Gains.test.frob:1:1
    |
  1 | import Gains
    | ^^^^^^^^^^^^
    |
    = hint: remove it
  
  1 warning
  $ frobc fix Gains.test.frob
  Gains.test.frob:1:1: remove it (W0306)
  1 more fix may not be what you meant; to apply it, run frobc fix --all
  warning[W0306]: `Sources` is imported, but nothing from it is used
   --> Gains.frob:1:1
    |
  1 | import Sources
    | ^^^^^^^^^^^^^^
    |
    = hint: remove it
  
  1 warning
  $ head -n 2 Gains.test.frob
  import Trial
  

Formatting and fixing treat it like any other file.

  $ printf 'import Trial\ntest   "is two" = during 1[s] (proc () ->   gain == 2)\n' > Gains.test.frob
  $ frobc format Gains.test.frob && cat Gains.test.frob
  import Trial
  test "is two" = during 1[s] (proc () -> gain == 2)
  $ frobc test Gains.frob 2> /dev/null
  ok    is two: 1 s
  1 test: all hold
