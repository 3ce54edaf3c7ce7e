Functions and data types can have size variables. One definition serves all
sizes, and `generate`, `length` and constants take their size from the type.

  $ cat > ring.frob <<'FROB'
  > data Ring n a = Ring { items :: Array n a, next :: Int }
  > 
  > filled :: a -> Ring n a
  > filled x = Ring { items = generate (const x), next = 0 }
  > 
  > -- | The ring with one more item, in place of the oldest.
  > push :: a -> Ring n a -> Ring n a
  > push x r = Ring { items = replace r.next x r.items, next = (r.next + 1) `mod` length r.items }
  > 
  > oldest :: Ring n a -> a
  > oldest r = at r.next (r.items ! 0) r.items
  > 
  > record :: a -> SF a (Ring n a)
  > record x0 = proc x -> r where
  >     r = push x (delay (filled x0) r)
  > 
  > main :: SF Int (Int, Int, Ring 3 Int)
  > main = proc i -> (oldest (record 0 i :: Ring 1 Int), oldest three, three) where
  >     three = record (-1) i
  > FROB
  $ printf 'time,in\n0,1\n1,2\n2,3\n3,4\n4,5\n' > in.csv
  $ frobc trace ring.frob --input in.csv | tee c.csv
  time,out.1,out.2,out.3.items[0],out.3.items[1],out.3.items[2],out.3.next
  0.000000000,1,-1,1,-1,-1,1
  1.000000000,2,-1,1,2,-1,2
  2.000000000,3,1,1,2,3,0
  3.000000000,4,2,4,2,3,1
  4.000000000,5,3,4,5,3,2
  $ frobc trace ring.frob --input in.csv --engine interp | cmp - c.csv

The state consists of the items and a number, nothing else:

  $ frobc report ring.frob | head -9
  state, in bytes
    main              24         ring.frob:18
      record.items    12  delay  ring.frob:15
      record.next      4  delay  ring.frob:15
      record_2.items   4  delay  ring.frob:15
      record_2.next    4  delay  ring.frob:15
  
  operations of a step, at most
    additions                 2

It is an error if two arguments have different sizes, if nothing determines a size, and if an array
has no elements or too many:

  $ cat > wrong.frob <<'FROB'
  > add :: SF (Array 2 Float) (Array 2 Float)
  > add = proc xs -> zipWith (+) xs [1, 2, 3]
  > 
  > undecided :: SF () Int
  > undecided = proc _ -> length (generate id)
  > 
  > empty = []
  > 
  > none :: Array 0 Float -> Float
  > none xs = 0
  > 
  > swapped :: Array Float 3 -> Float
  > swapped xs = 0
  > 
  > data Ring n = Ring { items :: Array n Float }
  > 
  > big :: Ring 5 -> Ring 4
  > big r = r
  > FROB
  $ frobc check wrong.frob
  error[E0301]: expected `Array 2 Float`, found `Array 3 Float`
   --> wrong.frob:2:33
    |
  2 | add = proc xs -> zipWith (+) xs [1, 2, 3]
    |                  -------     -- ^^^^^^^^^
    |                  |           |
    |                  |           because this is `Array 2 Float`
    |                  argument 3 of `zipWith` is `Array 2 Float`
    |
    = hint: remove one element, or write `Array 3 Float` in the type
  
  error[E0331]: nothing determines the size of an array where `generate` is used
   --> wrong.frob:5:31
    |
  5 | undecided = proc _ -> length (generate id)
    |                               ^^^^^^^^
    |
    = hint: add a type annotation, as in `(e :: Array 4 Float)`, or give the definition a signature
  
  error[E0333]: an array must have at least one element
   --> wrong.frob:7:9
    |
  7 | empty = []
    |         ^^
  
  error[E0333]: the size of an array must be from 1 to 1048576, not 0
   --> wrong.frob:9:15
    |
  9 | none :: Array 0 Float -> Float
    |               ^
  
  error[E0330]: expected the size of an array, found the type `Float`
    --> wrong.frob:12:18
     |
  12 | swapped :: Array Float 3 -> Float
     |                  ^^^^^
     |
     = hint: write the size first: `swapped :: Array 3 Float -> Float`
  
  error[E0301]: expected `Ring 4`, found `Ring 5`
    --> wrong.frob:18:9
     |
  17 | big :: Ring 5 -> Ring 4
     |        ---------------- the signature of `big` requires `Ring 4`
  18 | big r = r
     |         ^
  
  6 errors
  [1]
  $ echo 'x = (generate id :: Array 1048577 Int)' > big.frob
  $ frobc check big.frob
  error[E0333]: the size of an array must be from 1 to 1048576, not 1048577
   --> big.frob:1:27
    |
  1 | x = (generate id :: Array 1048577 Int)
    |                           ^^^^^^^
  
  1 error
  [1]
