Operators that a program defines, and instances of the built-in classes. The test pastes each fix.

  $ cat > own.frob <<'FROB'
  > (<+>) :: Float -> Float -> Float
  > a <+> b = (a + b) / 2
  > main :: SF (Float, Float) Float
  > main = proc (x, y) -> x <+> y
  > FROB
  $ frobc check own.frob
  error[E0110]: Frob has no `<+>`
   --> own.frob:1:2
    |
  1 | (<+>) :: Float -> Float -> Float
    |  ^^^
    |
    = hint: programs cannot define operators: define a function, such as `combine a b = (a + b) / 2`, and write ``a `combine` b``
  
  1 error
  [1]
  $ sed 's/(<+>) ::/combine ::/; s/^a <+> b/combine a b/; s/<+>/`combine`/' own.frob > pasted.frob && frobc check pasted.frob

  $ cat > of_a_class.frob <<'FROB'
  > data Cell = Cell Int Int
  > instance Num Cell where
  >     Cell a b + Cell c d = Cell (a + c) (b + d)
  > main :: SF Float Float
  > main = proc x -> x
  > FROB
  $ frobc check of_a_class.frob
  error[E0114]: the left-hand side of a definition cannot contain `+`: programs cannot define operators
   --> of_a_class.frob:3:14
    |
  3 |     Cell a b + Cell c d = Cell (a + c) (b + d)
    |              ^
    |
    = hint: outside the instance, define a function, such as `combine a b = …`, and write ``a `combine` b``
  
  1 error
  [1]

  $ cat > equal.frob <<'FROB'
  > data Cell = Cell { row, column :: Int }
  > instance Eq Cell where
  >     -- both numbers
  >     a == b = a.row == b.row && a.column == b.column
  > main :: SF Int Bool
  > main = proc n -> Cell { row = n, column = 0 } == Cell { row = 1, column = 0 }
  > FROB
  $ frobc check equal.frob
  error[E0366]: you cannot declare an instance of `Eq`
   --> equal.frob:2:10
    |
  2 | instance Eq Cell where
    |          ^^^^^^^
    |
    = note: the compiler already compares all values by structure, except those that contain functions
    = hint: remove the instance
  
  1 error
  [1]
  $ sed '2,4d' equal.frob > pasted.frob && frobc check pasted.frob

  $ cat > less.frob <<'FROB'
  > data Cell a = Cell a
  > instance Ord a => Ord (Cell a) where
  >     less (Cell a) (Cell b) = a < b
  >     (>) (Cell a) (Cell b) = a > b
  > main :: SF Int Bool
  > main = proc n -> Cell n < Cell 1
  > FROB
  $ frobc check less.frob
  error[E0366]: you cannot declare an instance of `Ord`
   --> less.frob:2:19
    |
  2 | instance Ord a => Ord (Cell a) where
    |                   ^^^^^^^^^^^
    |
    = note: the compiler already compares all values by structure, except those that contain functions
    = hint: remove the instance
  
  1 error
  [1]
  $ sed '2,4d' less.frob > pasted.frob && frobc check pasted.frob
