Classes, assertions and tests that lack a part.

  $ cat > class_no_where.frob <<'FROB'
  > class Shape a
  >     area :: a -> Float
  > data Sq = Sq Float
  > instance Shape Sq where
  >     area (Sq x) = x * x
  > main = proc x -> area (Sq x)
  > FROB
  $ frobc check class_no_where.frob
  error[E0110]: expected `->` or the end of the type after a type variable, found `::`
   --> class_no_where.frob:2:10
    |
  2 |     area :: a -> Float
    |          ^^
    |
    = hint: add `where`, and write the methods below it: `class Shape a where`
  
  1 error
  [1]

  $ cat > instance_extra_method.frob <<'FROB'
  > class Shape a where
  >     area :: a -> Float
  > data Sq = Sq Float
  > instance Shape Sq where
  >     area s = case s of Sq x -> x * x
  >     size s = 1
  > main = proc x -> area (Sq x)
  > FROB
  $ frobc check instance_extra_method.frob
  error[E0230]: `size` is not a method of the class `Shape`
   --> instance_extra_method.frob:6:5
    |
  1 | class Shape a where
    |       ----- the methods are declared here
  ...
  6 |     size s = 1
    |     ^^^^
    |
    = hint: if it is a separate function, move it to the left margin; if every `Shape` must have it, add its signature to the class
  
  1 error
  [1]

  $ cat > no_instance.frob <<'FROB'
  > class Shape a where
  >     area :: a -> Float
  > data Sq = Sq Float
  > main = proc x -> area (Sq x)
  > FROB
  $ frobc check no_instance.frob
  error[E0360]: there is no instance `Shape Sq`
   --> no_instance.frob:4:18
    |
  2 |     area :: a -> Float
    |             ---------- `area` requires `Shape a` here
  3 | data Sq = Sq Float
  4 | main = proc x -> area (Sq x)
    |                  ^^^^ `area` needs it
    |
    = hint: add `instance Shape Sq where`, and define the methods below it
  
  1 error
  [1]

  $ cat > constraint_missing.frob <<'FROB'
  > bigger :: a -> a -> a
  > bigger x y = if x > y then x else y
  > main = proc (x, y) -> bigger x y
  > FROB
  $ frobc check constraint_missing.frob
  error[E0309]: `>` needs `Ord a`, which the signature of `bigger` does not declare
   --> constraint_missing.frob:2:19
    |
  1 | bigger :: a -> a -> a
    |           ----------- the signature of `bigger`
  2 | bigger x y = if x > y then x else y
    |                   ^
    |
    = hint: write `Ord a => a -> a -> a`
  
  1 error
  [1]

  $ cat > assert_event.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 0) where
  >     assert safe: frontSonar i > 0.2[m])
  > FROB
  $ frobc check assert_event.frob
  error[E0103]: unexpected character `:`
   --> assert_event.frob:3:16
    |
  3 |     assert safe: frontSonar i > 0.2[m])
    |                ^
    |
    = hint: add a label in quotes: `assert "keeps off the wall" (x > 0)`
  
  1 error
  [1]

  $ cat > assert_noname.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 0) where
  >     assert frontSonar i > 0.2[m])
  > FROB
  $ frobc check assert_noname.frob
  error[E0110]: an `assert` needs a label that describes its condition
   --> assert_noname.frob:3:5
    |
  3 |     assert frontSonar i > 0.2[m])
    |     ^^^^^^
    |
    = hint: write `assert "keeps off the wall" (frontSonar i > 0.2[m])`
  
  1 error
  [1]

  $ cat > test_block.frob <<'FROB'
  > import Robot
  > import Trial
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 0))
  > test "drives" = comesFar 1[m] 10[s]
  > FROB
  $ frobc check test_block.frob
  error[E0301]: expected a `Test`, which also says how long to run the signal function
   --> test_block.frob:4:17
    |
  4 | test "drives" = comesFar 1[m] 10[s]
    |      --------   ^^^^^^^^^^^^^^^^^^^ this is `SF Truth Verdict`
    |      |
    |      the value after this name must be `Test`
    |
    = hint: for a run in the simulator, write a trial: `trial "name" = Trial { world = "room.toml", lasts = 10[s], seeds = 1 `to` 20, judge = comesFar 1[m] 10[s] }`
  
  1 error
  [1]

  $ cat > neither_is_known.frob <<'FROB'
  > f x = Fast (compute x)
  > main = proc x -> f x
  > FROB
  $ frobc check neither_is_known.frob
  error[E0206]: unknown constructor `Fast`
   --> neither_is_known.frob:1:7
    |
  1 | f x = Fast (compute x)
    |       ^^^^  ------- unknown name `compute`
    |
    = hint: define both, or `import` the module that defines them
  
  1 error
  [1]

  $ cat > left_twice.frob <<'FROB'
  > import Robot
  > f :: Either Float Bool -> Float
  > f e = case e of
  >     Left x -> x
  >     Left b -> if b then 1 else 0
  > main = proc x -> f (Left x)
  > FROB
  $ frobc check left_twice.frob
  error[E0301]: `Left` is matched twice, and `Right` is never matched
   --> left_twice.frob:5:5
    |
  4 |     Left x -> x
    |     ------ this branch already matches every such value
  5 |     Left b -> if b then 1 else 0
    |     ^^^^^^
    |
    = hint: if this branch is for the other values, write `Right`
  
  1 error
  [1]

  $ cat > too_general.frob <<'FROB'
  > raised :: Float[u] -> Float[u]
  > raised x = x + 1[m]
  > flip' :: a -> Bool
  > flip' x = not x
  > tw :: float[m] -> float[m]
  > tw x = x + x
  > main = proc x -> raised x
  > FROB
  $ frobc check too_general.frob
  error[E0306]: the signature allows any unit `u`, but the definition needs it to be `m`
   --> too_general.frob:2:16
    |
  1 | raised :: Float[u] -> Float[u]
    |           -------------------- `u` is any unit in the signature of `raised`
  2 | raised x = x + 1[m]
    |                ^^^^ this is `Float[m]`
    |
    = hint: if the definition is right, write the signature as `Float[m] -> Float[m]`
  
  error[E0306]: the signature allows any type `a`, but the definition needs it to be `Bool`
   --> too_general.frob:4:15
    |
  3 | flip' :: a -> Bool
    |          --------- `a` is any type in the signature of `flip'`
  4 | flip' x = not x
    |               ^
    |
    = hint: if the definition is right, write the signature as `Bool -> Bool`
  
  warning[W0302]: `float` is a type variable here, so it means any type
   --> too_general.frob:5:7
    |
  5 | tw :: float[m] -> float[m]
    |       ^^^^^^^^^^^^^^^^^^^^
    |
    = hint: if you meant the type, write `Float`
  
  2 errors, 1 warning
  [1]
