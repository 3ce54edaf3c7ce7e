More of C and MATLAB: choices, arrays, numbers and functions.

A choice by values, with a colon on each line: reported once.

  $ cat > switch.frob <<'FROB'
  > main :: SF Int Int
  > main = proc n -> y where
  >     switch (n) {
  >         case 1: y = 2;
  >         default: y = 0;
  >     }
  > FROB
  $ frobc check switch.frob
  error[E0103]: unexpected character `:`
   --> switch.frob:4:15
    |
  4 |         case 1: y = 2;
    |               ^
    |
    = hint: to choose by value, write `case n of`, and below it one branch on each line, such as `1 -> x`, ending with `_ -> y`
  
  1 error
  [1]

Rows of a matrix:

  $ cat > rows.frob <<'FROB'
  > m = [1, 2; 3, 4]
  > main :: SF Float Float
  > main = proc x -> x
  > FROB
  $ frobc check rows.frob
  error[E0111]: array elements are not separated by `;`
   --> rows.frob:1:10
    |
  1 | m = [1, 2; 3, 4]
    |          ^
    |
    = hint: the rows of a matrix are arrays: write `[[1, 2], [3, 4]]`
  
  1 error
  [1]

  $ cat > sizes.frob <<'FROB'
  > double :: Array n Float -> Array (2 * n) Float
  > double xs = xs
  > main :: SF Float Float
  > main = proc x -> x
  > FROB
  $ frobc check sizes.frob
  error[E0330]: `n` is a variable, but arithmetic on sizes needs known numbers
   --> sizes.frob:1:39
    |
  1 | double :: Array n Float -> Array (2 * n) Float
    |                                       ^
    |
    = hint: use another variable for the result, as in `double :: Array n Float -> Array k Float`
  
  1 error
  [1]

  $ cat > bars.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> |x|
  > FROB
  $ frobc check bars.frob
  error[E0110]: expected the output of this `proc`, or `do`, after `->`, found `|`
   --> bars.frob:2:18
    |
  2 | main = proc x -> |x|
    |                  ^
    |
    = hint: use `abs x` for the absolute value of `x`
  
  1 error
  [1]

  $ cat > atan2.frob <<'FROB'
  > main :: SF (Float, Float) Float
  > main = proc (x, y) -> atan (y, x)
  > FROB
  $ frobc check atan2.frob
  error[E0301]: expected `Float`, found a tuple with 2 elements
   --> atan2.frob:2:28
    |
  2 | main = proc (x, y) -> atan (y, x)
    |                       ---- ^^^^^^
    |                       |
    |                       argument 1 of `atan` is `Float`
    |
    = hint: for two numbers, write `atan2 y x`
  
  1 error
  [1]

  $ cat > c_types.frob <<'FROB'
  > foreign lut :: double -> double = "lut"
  > main :: SF Float Float
  > main = proc x -> lut x
  > FROB
  $ frobc check c_types.frob
  error[E0380]: `lut` cannot give C a value of type `double`
   --> c_types.frob:1:16
    |
  1 | foreign lut :: double -> double = "lut"
    |                ^^^^^^^^^^^^^^^^
    |
    = note: a lower-case name is a type variable
    = hint: write this C type as `Float`, which is a `double`
  
  1 error
  [1]

  $ cat > pointer.frob <<'FROB'
  > foreign fill :: Array 8 Float* -> Int = "fill"
  > main :: SF Float Int
  > main = proc x -> fill [x, x, x, x, x, x, x, x]
  > FROB
  $ frobc check pointer.frob
  error[E0110]: expected `->` or the end of this type, found `*`
   --> pointer.frob:1:30
    |
  1 | foreign fill :: Array 8 Float* -> Int = "fill"
    |                              ^
    |
    = hint: remove the `*`: arrays and records are always passed to C by address
  
  1 error
  [1]

  $ cat > const.frob <<'FROB'
  > const double gain = 2.0;
  > main :: SF Float Float
  > main = proc x -> gain * x
  > FROB
  $ frobc check const.frob
  error[E0205]: unknown name `gain`
   --> const.frob:3:18
    |
  1 | const double gain = 2.0;
    | ----- this defines a function `const`
  2 | main :: SF Float Float
  3 | main = proc x -> gain * x
    |                  ^^^^
    |
    = hint: declare it as `gain :: Float` and, on the next line, `gain = 2.0`
  
  1 error
  [1]

Syntax that is only valid at the left edge, and ranges:

  $ cat > param.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR cruise 0) where
  >     param cruise :: Velocity = 0.2[m/s])
  > FROB
  $ frobc check param.frob
  error[E0110]: expected a definition or a signature, found `param`
   --> param.frob:3:5
    |
  3 |     param cruise :: Velocity = 0.2[m/s])
    |     ^^^^^
    |
    = hint: move the `param` to the top level, without indentation
  
  1 error
  [1]

  $ cat > seeds.frob <<'FROB'
  > import Robot
  > import Trial
  > import WallFollow
  > main = reactimateRobot (wallFollow1 0.3[m])
  > trial "no touching" = Trial { world = "room.toml", lasts = 60, seeds = [1..20], judge = neverTouches }
  > FROB
  $ frobc check seeds.frob
  error[E0110]: Frob has no `..`
   --> seeds.frob:5:74
    |
  5 | trial "no touching" = Trial { world = "room.toml", lasts = 60, seeds = [1..20], judge = neverTouches }
    |                                                                          ^^
    |
    = hint: use ``1 `to` 20`` without brackets; it includes both numbers
  
  1 error
  [1]
