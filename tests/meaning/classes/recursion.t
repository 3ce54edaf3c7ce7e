Two defaults that refer to each other form a cycle in an instance that defines
neither.

  $ cat > defaults.frob <<EOF
  > class Ordered a where
  >     less, more :: a -> a -> Bool
  >     less x y = more y x
  >     more x y = less y x
  > data T = T Float
  > data U = U Float
  > instance Ordered T
  > instance Ordered U where
  >     less x y = case (x, y) of
  >         (U a, U b) -> a < b
  > EOF
  $ frobc check defaults.frob
  error[E0410]: `less` calls itself through other definitions
   --> defaults.frob:3:5
    |
  3 |     less x y = more y x
    |     ^^^^^^^^^^^^^^^^^^^
    |     |          |
    |     |          `less` uses `more` here
    |     `less → more → less`
  4 |     more x y = less y x
    |                ---- `more` uses `less` here
    |
    = note: functions cannot be recursive: use `foldl` or `scanl` to process an array; a signal function may only restart itself in the continuation of a switch
    = note: this happens for the type `T`, because its instance of `Ordered` relies on default methods
    = hint: define one of the methods in the instance
  
  1 error
  [1]

The message about a cycle through an instance lists its steps, as for functions.

  $ cat > through.frob <<EOF
  > class Level a where
  >     level :: SF a Float
  > above :: Level a => SF a Float
  > above = proc x -> level x + 1
  > data T = T Float
  > instance Level T where
  >     level = proc t -> above t
  > main :: SF Float Float
  > main = proc x -> above (T x)
  > EOF
  $ frobc check through.frob
  error[E0410]: `level@T` calls itself through other definitions
   --> through.frob:7:5
    |
  4 | above = proc x -> level x + 1
    |                   ----- `above` uses `level@T` here
  ...
  7 |     level = proc t -> above t
    |     ^^^^^^^^^^^^^^^^^^^^^^^^^
    |     |                 |
    |     |                 `level@T` uses `above` here
    |     `level@T → above → level@T`
    |
    = note: functions cannot be recursive: use `foldl` or `scanl` to process an array; a signal function may only restart itself in the continuation of a switch
  
  1 error
  [1]

A method of a component is not a cycle, however deeply the components are
nested; types that grow without limit are rejected.

  $ cat > parts.frob <<EOF
  > class Depth a where
  >     depth :: a -> Int
  > below :: Depth a => a -> Int
  > below x = depth x + 1
  > data Leaf = Leaf
  > instance Depth Leaf where
  >     depth _ = 0
  > instance Depth a => Depth (Maybe a) where
  >     depth m = case m of
  >         Nothing -> 0
  >         Just x -> below x
  > main :: SF Bool Int
  > main = proc b -> depth (Just (Just (if b then Just Leaf else Nothing)))
  > EOF
  $ printf 'time,in\n0,true\n1,false\n' > in.csv
  $ frobc trace parts.frob --input in.csv
  time,out
  0.000000000,3
  1.000000000,2
  $ cat > growing.frob <<EOF
  > class Depth a where
  >     depth :: a -> Int
  > below :: Depth a => a -> Int
  > below x = depth x
  > instance Depth Float[u] where
  >     depth _ = 0
  > instance Depth a => Depth (Maybe a) where
  >     depth m = below (Just m)
  > main :: SF Float Int
  > main = proc x -> below (Just x)
  > EOF
  $ frobc check growing.frob
  error[E0413]: `below` uses itself at ever larger types
   --> growing.frob:8:15
    |
  4 | below x = depth x
    | ----------------- defined here
  ...
  8 |     depth m = below (Just m)
    |               ^^^^^
  
  1 error
  [1]

A program with a polymorphic type cannot be run.

  $ cat > open.frob <<EOF
  > class HasSonar i where
  >     frontDistance :: SF i Distance
  > main :: HasSonar i => SF i Distance
  > main = frontDistance
  > EOF
  $ frobc check open.frob
  error[E0411]: `main` cannot run: its type `HasSonar i => SF i Float[m]` has variables, so the input or the output is not determined
   --> open.frob:4:1
    |
  4 | main = frontDistance
    | ^^^^^^^^^^^^^^^^^^^^
    |
    = hint: give it a signature without variables, such as `main :: SF Float Float`
  
  1 error
  [1]
  $ frobc compile open.frob
  error[E0411]: `main` cannot run: its type `HasSonar i => SF i Float[m]` has variables, so the input or the output is not determined
   --> open.frob:4:1
    |
  4 | main = frontDistance
    | ^^^^^^^^^^^^^^^^^^^^
    |
    = hint: give it a signature without variables, such as `main :: SF Float Float`
  
  1 error
  [1]
