Tuples, records and texts, used as in other languages.

  $ cat > index.frob <<'FROB'
  > main :: SF (Float, Float) Float
  > main = proc p -> p[0] + p[1]
  > FROB
  $ frobc check index.frob
  error[E0110]: a `[` directly after a name is neither an index nor an array
   --> index.frob:2:19
    |
  2 | main = proc p -> p[0] + p[1]
    |                   ^
    |
    = hint: write `(p ! 0)` for an element of an array; to take a tuple apart, write an equation such as `(a, b) = p`; to pass an array as an argument, put a space before the `[`
  
  1 error
  [1]

  $ cat > selected.frob <<'FROB'
  > main :: SF (Float, Float) Float
  > main = proc p -> p.1
  > FROB
  $ frobc check selected.frob
  error[E0301]: expected `a -> b`, found `(Float, Float)`
   --> selected.frob:2:18
    |
  2 | main = proc p -> p.1
    |                  ^- argument 1 of `.` is `b -> c`
    |
    = hint: to get the elements of a tuple, write an equation: `(a, b) = p`; for a pair, you can also write `fst p` and `snd p`
  
  1 error
  [1]

  $ cat > record.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     v = if (sonars i) ! 3 < 0.5[m] then 0 else 0.2[m/s])
  > FROB
  $ frobc check record.frob
  error[E0301]: expected `Float[m]`, found `Sonar`
   --> record.frob:3:12
    |
  3 |     v = if (sonars i) ! 3 < 0.5[m] then 0 else 0.2[m/s])
    |            ^^^^^^^^^^^^^^   ------ this is `Float[m]`
    |
    = hint: this is a record: choose one of its fields, `((sonars i) ! 3).seat`, `((sonars i) ! 3).halfAngle`, `((sonars i) ! 3).echo`
  
  1 error
  [1]

  $ cat > update.frob <<'FROB'
  > import Robot
  > data C = C { a :: Float }
  > f :: C -> C
  > f c = c { a + 1 }
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0 0))
  > FROB
  $ frobc check update.frob
  error[E0110]: expected `=`, `,` or `}` after the name of a field, found `+`
   --> update.frob:4:13
    |
  4 | f c = c { a + 1 }
    |             ^
    |
    = hint: set a field with `=`, even if the value depends on the old one: `r { a = r.a + 1 }`
  
  1 error
  [1]

  $ cat > text.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR v 0) where
  >     mode = "go"
  >     v = if mode == "go" then 0.2[m/s] else 0)
  > FROB
  $ frobc check text.frob
  error[E0307]: `String` has no equality
   --> text.frob:4:17
    |
  4 |     v = if mode == "go" then 0.2[m/s] else 0)
    |                 ^^ `==` needs it
    |
    = hint: a string is only a label: for a choice, declare a type, as in `data Mode = Go | Stop`
  
  1 error
  [1]

  $ cat > defined.frob <<'FROB'
  > main :: SF Float Float
  > main = proc x -> y where
  >     y == x + 1
  > FROB
  $ frobc check defined.frob
  error[E0110]: expected `=` after the left-hand side of a definition, found the end of the block
   --> defined.frob:3:15
    |
  3 |     y == x + 1
    |               ^
    |
    = hint: write a single `=` to define a name, as in `y = …`; `==` compares two values
  
  1 error
  [1]
