Instances can be for any type constructor: numbers of all units, tuples,
functions, signal functions. A context can require classes of the constructor's
arguments, including the built-in ones.

  $ cat > constructors.frob <<EOF
  > class Size a where
  >     size :: a -> Int
  > instance Size Float[u] where
  >     size x = if x < 0 then -1 else 1
  > instance Size Int[u] where
  >     size _ = 10
  > instance Size Bool where
  >     size _ = 100
  > instance Size () where
  >     size _ = 1000
  > instance (Size a, Size b) => Size (a, b) where
  >     size (x, y) = size x + size y
  > instance (Eq a, Size a) => Size (Maybe a) where
  >     size m = case m of
  >         Nothing -> 0
  >         Just x -> if m == Just x then 2 * size x else 7
  > instance Size (a -> b) where
  >     size _ = 5
  > instance Size (SF a b) where
  >     size _ = 6
  > 
  > twice :: Size n[u] => n[u] -> Int
  > twice x = size (x, x)
  > 
  > inferred x = size (x + x)
  > 
  > main :: SF (Float[m], Int, Maybe (Bool, Float)) (Int, Int, Int, Int, Int, Int)
  > main = proc (x, n, m) -> (size (x, n), size m, twice x + twice n, inferred n, size sin + size (delay m), size ((), 3))
  > EOF
  $ cat > in.csv <<EOF
  > time,in.1,in.2,in.3
  > 0,-1,3,Nothing
  > 1,2,3,"Just (true, 2)"
  > 2,2,3,"Just (true, nan)"
  > EOF
  $ frobc trace constructors.frob --lint --input in.csv
  time,out.1,out.2,out.3,out.4,out.5,out.6
  0.000000000,9,0,18,10,11,1001
  1.000000000,11,202,22,10,11,1001
  2.000000000,11,7,22,10,11,1001
  $ frobc trace --engine interp constructors.frob --input in.csv | tail -1
  2.000000000,11,7,22,10,11,1001

Methods with their own type, unit and representation variables, and with their
own context:

  $ cat > own.frob <<EOF
  > class Container f where
  >     scaled :: Float[u] -> f -> n[v] -> (Float[u], n[v])
  >     choose :: (Ord a, Eq b) => f -> a -> a -> b -> (a, Bool)
  >     choose _ x y z = (max x y, z == z)
  > 
  > type Boxed b = Box b
  > data Box a = Box { content :: a }
  > instance Container (Boxed a) where
  >     scaled k _ x = (2 * k, x + x)
  > instance Container Bool where
  >     scaled k b x = (k, if b then x else 0)
  >     choose b x y z = if b then (min x y, other z) else (x, False) where
  >         other :: b -> Bool
  >         other _ = True
  > 
  > main :: SF (Float[m], Int) ((Float[m], Int), (Float[s], Float[m]), (Int, Bool), (Float[m], Bool))
  > main = proc (x, n) -> (scaled x (Box x) n, scaled 3[s] False x, choose (Box n) n 5 x, choose (x > 0) x 4[m] n)
  > EOF
  $ cat > in.csv <<EOF
  > time,in.1,in.2
  > 0,-1,3
  > 1,2,7
  > EOF
  $ frobc trace own.frob --lint --input in.csv
  time,out.1.1,out.1.2,out.2.1,out.2.2,out.3.1,out.3.2,out.4.1,out.4.2
  0.000000000,-2,6,3,0,5,true,-1,false
  1.000000000,4,14,3,0,7,true,2,true
  $ frobc trace --engine interp own.frob --input in.csv | tail -1
  1.000000000,4,14,3,0,7,true,2,true

Methods can be imported with their class or individually; instances apply whenever their module is
part of the program.

  $ cat > Shapes.frob <<EOF
  > module Shapes (Shape, Square, Sized, weight) where
  > class Shape a where
  >     area :: a -> Float
  > class Sized a where
  >     weight, secret :: a -> Float
  >     secret x = weight x + 1
  > data Square = Square Float
  > instance Shape Square where
  >     area s = case s of
  >         Square x -> x * x
  > instance Sized Square where
  >     weight s = area s
  > EOF
  $ cat > importer.frob <<EOF
  > import qualified Shapes as S
  > import Shapes (Square, weight)
  > data Double' = Double' Square
  > instance S.Shape Double' where
  >     area d = case d of
  >         Double' s -> 2 * S.area s
  > main :: SF Float Float
  > main = proc x -> S.area (Double' (Square x)) + weight (Square x)
  > EOF
  $ printf 'time,in\n0,3\n' > one.csv
  $ frobc trace importer.frob --lint --input one.csv
  time,out
  0.000000000,27
  $ cat > hidden.frob <<EOF
  > import Shapes (weight, area, Shapes)
  > import qualified Shapes
  > f x = Shapes.secret x + Shapes.sekret x
  > instance Shape Bool where
  > g :: Shapes.Sizd a => a -> a
  > g x = x
  > EOF
  $ frobc check hidden.frob
  error[E0215]: module `Shapes` has no `Shapes` to import
   --> hidden.frob:1:30
    |
  1 | import Shapes (weight, area, Shapes)
    |                              ^^^^^^
    |
    = hint: did you mean `Shape`?
  
  error[E0205]: module `Shapes` has no name `sekret`
   --> hidden.frob:3:32
    |
  3 | f x = Shapes.secret x + Shapes.sekret x
    |                                ^^^^^^
    |
    = hint: did you mean `secret`?
  
  error[E0223]: unknown type class `Shape`
   --> hidden.frob:4:10
    |
  4 | instance Shape Bool where
    |          ^^^^^
    |
    = hint: its module is imported with `qualified`: write `Shapes.Shape`
  
  error[E0223]: module `Shapes` has no type class `Sizd`
   --> hidden.frob:5:13
    |
  5 | g :: Shapes.Sizd a => a -> a
    |             ^^^^
    |
    = hint: did you mean `Sized`?
  
  4 errors
  [1]
