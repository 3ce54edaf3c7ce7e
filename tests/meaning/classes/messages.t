A message about a missing instance points to the place that needs it, and to the
definition that requires it.

  $ cat > needed.frob <<EOF
  > class Shape a where
  >     area :: a -> Float[m^2]
  >     twice :: a -> Float[m^2]
  >     twice x = 2 * area x
  > 
  > data Square = Square { side :: Distance }
  > data Disc = Disc { radius :: Distance }
  > data Bag a = Bag a a
  > 
  > instance Shape Square where
  >     area s = s.side * s.side
  > 
  > instance Shape a => Shape (Bag a) where
  >     area b = case b of
  >         Bag x y -> area x + area y
  > 
  > instance (Eq a, Shape a) => Shape (Maybe a) where
  >     area m = if m == Nothing then 0 else 1[m^2]
  > 
  > total :: (Shape a, Shape b) => a -> b -> Float[m^2]
  > total x y = area x + area y
  > 
  > -- missing
  > e1 = total (Square { side = 1[m] }) (Disc { radius = 1[m] })
  > -- through
  > e2 = area (Bag (Disc { radius = 1[m] }) (Disc { radius = 1[m] }))
  > -- not promised
  > e3 :: a -> Float[m^2]
  > e3 x = area x
  > -- unit
  > e4 = area 3.0
  > -- eq in instance
  > e5 = area (Just sin)
  > -- undecided
  > e6 = area Nothing
  > -- inferred
  > f7 x = area x + twice (Bag x x)
  > e7 = f7 True
  > e8 x = (x == x, area x)
  > f9 n = area (n + 1)
  > e10 = f9 2
  > EOF
  $ frobc check needed.frob
  error[E0360]: there is no instance `Shape Disc`
    --> needed.frob:24:6
     |
  20 | total :: (Shape a, Shape b) => a -> b -> Float[m^2]
     |           ----------------------------------------- `total` requires `Shape b` here
  ...
  24 | e1 = total (Square { side = 1[m] }) (Disc { radius = 1[m] })
     |      ^^^^^ `total` needs it
     |
     = hint: add `instance Shape Disc where`, and define the methods below it
  
  error[E0360]: there is no instance `Shape Disc`
    --> needed.frob:26:6
     |
   2 |     area :: a -> Float[m^2]
     |             --------------- `area` requires `Shape a` here
  ...
  13 | instance Shape a => Shape (Bag a) where
     |                     ------------ this instance requires `Shape Disc`
  ...
  26 | e2 = area (Bag (Disc { radius = 1[m] }) (Disc { radius = 1[m] }))
     |      ^^^^ `area` needs it
  
  error[E0309]: `area` needs `Shape a`, which the signature of `e3` does not declare
    --> needed.frob:29:8
     |
   2 |     area :: a -> Float[m^2]
     |             --------------- `area` requires `Shape a` here
  ...
  28 | e3 :: a -> Float[m^2]
     |       --------------- the signature of `e3`
  29 | e3 x = area x
     |        ^^^^
     |
     = hint: write `Shape a => a -> Float[m^2]`
  
  error[E0360]: there is no instance `Shape Float`
    --> needed.frob:31:6
     |
   2 |     area :: a -> Float[m^2]
     |             --------------- `area` requires `Shape a` here
  ...
  31 | e4 = area 3.0
     |      ^^^^ `area` needs it
     |
     = hint: add `instance Shape Float where`, and define the methods below it
  
  error[E0307]: `Angle -> Float` has no equality
    --> needed.frob:33:6
     |
   2 |     area :: a -> Float[m^2]
     |             --------------- `area` requires `Shape a` here
  ...
  17 | instance (Eq a, Shape a) => Shape (Maybe a) where
     |                             -------------- this instance requires `Eq (Angle -> Float)`
  ...
  33 | e5 = area (Just sin)
     |      ^^^^ `area` needs it
  
  error[E0308]: nothing determines the type at which `area` is used
    --> needed.frob:35:6
     |
   2 |     area :: a -> Float[m^2]
     |             --------------- `area` requires `Shape a` here
  ...
  35 | e6 = area Nothing
     |      ^^^^
     |
     = note: the type must have an instance of the class `Eq`
     = hint: add a type annotation, as in `(e :: T)`
  
  error[E0360]: there is no instance `Shape Bool`
    --> needed.frob:38:6
     |
  38 | e7 = f7 True
     |      ^^ `f7` needs it
     |
     = hint: add `instance Shape Bool where`, and define the methods below it
  
  error[E0360]: there is no instance `Shape Float`
    --> needed.frob:41:7
     |
  41 | e10 = f9 2
     |       ^^ `f9` needs it
     |
     = hint: add `instance Shape Float where`, and define the methods below it
  
  8 errors
  [1]

Invalid instances, and instances that lack definitions:

  $ cat > declared.frob <<EOF
  > class Base a where
  >     base :: a -> Float
  > class Base a => Derived a where
  >     derived :: a -> Float
  >     derived x = 2 * base x
  >     both :: a -> b -> Float
  >     both x _ = derived x
  > class (Derived a, Ord a) => Third a where
  >     third :: SF a Float
  > data T = T Float
  > data W a = W a
  > data U = U { v :: Float }
  > instance Derived T where
  > instance Base a => Base (W a) where
  >     base w = case w of
  >         W x -> base x
  > instance Base a => Derived (W a)
  > instance Derived (Maybe a)
  > instance Base a => Base (Maybe a) where
  >     base x = 0
  > instance Base Float[u] where
  >     base x = x
  > instance Base (a, b)
  > instance Base a
  > instance Base n[u]
  > instance Base Float
  > instance Base (b, a) where
  >     base x = base (fst x)
  > type P = Maybe Bool
  > instance Base P where
  >     base _ = 0
  > instance Base U where
  >     base (u) = u.v
  > instance Third U where
  >     third = proc i -> base (i.v, i.v)
  > instance Eq b => Base Bool where
  >     base x = True
  > instance Base (a -> a) where
  >     base f = 0
  > instance Base Int[u] where
  >     base f n = 3
  > instance Ord U
  > use :: Third a => a -> Float
  > use x = base x + (if x == x then 1 else 0) + both x True
  > bad :: Third a => Float -> Float
  > bad x = x
  > bad2 :: Third (Maybe a) => Maybe a -> Float
  > bad2 x = 0
  > class Q a where
  >     q :: Float
  >     q' :: Eq a => a -> Bool
  > EOF
  $ frobc check declared.frob
  error[E0360]: there is no instance `Base T`
    --> declared.frob:13:10
     |
   3 | class Base a => Derived a where
     |       ---- `Base` is a superclass of `Derived`
  ...
  13 | instance Derived T where
     |          ^^^^^^^^^ `Derived T` needs it
     |
     = hint: add `instance Base T where`, and define the methods below it
  
  error[E0309]: `Derived (Maybe a)` needs `Base a`, which the instance of `Derived` does not declare
    --> declared.frob:18:10
     |
   3 | class Base a => Derived a where
     |       ---- `Base` is a superclass of `Derived`
  ...
  18 | instance Derived (Maybe a)
     |          ^^^^^^^^^^^^^^^^
     |
     = hint: start the instance of `Derived` with `Base a =>`, or add the constraint to the existing context: `(…, Base a) =>`
  
  error[E0306]: the signature allows any unit `u`, but the definition needs it to be `1`
    --> declared.frob:22:14
     |
  21 | instance Base Float[u] where
     |          ------------- `u` is any unit in the instance of `Base`
  22 |     base x = x
     |              ^ this is `Float[u]`
  
  error[E0363]: the instance `Base (a, b)` does not define `base`
    --> declared.frob:23:10
     |
   2 |     base :: a -> Float
     |             ---------- `base` has no default
  ...
  23 | instance Base (a, b)
     |          ^^^^^^^^^^^
     |
     = hint: below the `where` of the instance, define `base = …`
  
  error[E0362]: the head of an instance must be a type constructor applied to distinct variables, not `a`
    --> declared.frob:24:15
     |
  24 | instance Base a
     |               ^
  
  error[E0362]: the head of an instance must be a type constructor applied to distinct variables, not `n[u]`
    --> declared.frob:25:15
     |
  25 | instance Base n[u]
     |               ^^^^
     |
     = hint: write an instance for `Int[u]` and another for `Float[u]`
  
  error[E0362]: the head of an instance must be a type constructor applied to distinct variables, not `Float`
    --> declared.frob:26:15
     |
  26 | instance Base Float
     |               ^^^^^
     |
     = note: a unit cannot select an instance
     = hint: write a unit variable, as in `Float[u]`
  
  error[E0361]: there are two `Base (b, a)` instances
    --> declared.frob:27:10
     |
  23 | instance Base (a, b)
     |          ----------- the first one is here
  ...
  27 | instance Base (b, a) where
     |          ^^^^^^^^^^^
     |
     = note: a class can have only one instance for each type constructor
  
  error[E0362]: the head of an instance must be a type constructor applied to distinct variables, not `P`
    --> declared.frob:30:15
     |
  30 | instance Base P where
     |               ^
     |
     = note: this is a synonym for `Maybe Bool`
  
  error[E0360]: there is no instance `Derived U`
    --> declared.frob:34:10
     |
   8 | class (Derived a, Ord a) => Third a where
     |        ------- `Derived` is a superclass of `Third`
  ...
  34 | instance Third U where
     |          ^^^^^^^ `Third U` needs it
     |
     = hint: add `instance Derived U where`, and define the methods below it
  
  error[E0364]: the context contains `b`, but the type does not
    --> declared.frob:36:10
     |
  36 | instance Eq b => Base Bool where
     |          ^^^^         ---- nothing here determines the type `b`
  
  error[E0301]: expected `Float`, found `Bool`
    --> declared.frob:37:14
     |
   2 |     base :: a -> Float
     |             ---------- the signature of `base` requires `Float`
  ...
  37 |     base x = True
     |              ^^^^
     |
     = hint: a `Bool` is not a number: write `1`
  
  error[E0362]: the head of an instance must be a type constructor applied to distinct variables, not `a -> a`
    --> declared.frob:38:16
     |
  38 | instance Base (a -> a) where
     |                ^^^^^^
  
  error[E0302]: `base` has more than one parameter, but its type allows only one
    --> declared.frob:41:12
     |
   2 |     base :: a -> Float
     |             ---------- the signature of `base` requires `Int[u] -> Float`
  ...
  41 |     base f n = 3
     |            ^
     |
     = hint: the signature needs a type for each parameter (`f`, `n`) and one for the result: `base :: … -> … -> …`
  
  error[E0366]: you cannot declare an instance of `Ord`
    --> declared.frob:42:10
     |
  42 | instance Ord U
     |          ^^^^^
     |
     = note: the compiler already compares all values by structure, except those that contain functions
     = hint: remove the instance
  
  error[E0364]: the context contains `a`, but the type does not
    --> declared.frob:45:8
     |
  45 | bad :: Third a => Float -> Float
     |        ^^^^^^^    -------------- nothing here determines the type `a`
  
  error[E0365]: a context can only constrain a variable, not `Maybe a`
    --> declared.frob:47:9
     |
  47 | bad2 :: Third (Maybe a) => Maybe a -> Float
     |         ^^^^^^^^^^^^^^
  
  error[E0364]: the type of the method `q` does not contain `a`
    --> declared.frob:50:5
     |
  50 |     q :: Float
     |     ^    ----- nothing here determines the instance
  
  error[E0365]: the context of a method cannot constrain the class's own variable `a`
    --> declared.frob:51:11
     |
  51 |     q' :: Eq a => a -> Bool
     |           ^^^^
     |
     = hint: make `Eq` a superclass
  
  19 errors
  [1]

The definitions of a method have the types that the class declares.

  $ cat > bodies.frob <<EOF
  > class Shape a where
  >     area :: a -> Float[m^2]
  >     label :: a -> b -> b
  >     label _ x = x
  > 
  > data Square = Square { side :: Distance }
  > 
  > instance Shape Square where
  >     area s = 4 * s.side
  >     label s x = s
  > 
  > instance Shape a => Shape (Maybe a) where
  >     area m = case m of
  >         Nothing -> 0
  >         Just x -> x
  >     label m x = area m
  > 
  > instance Shape Bool where
  >     area b c = 3
  > EOF
  $ frobc check bodies.frob
  error[E0320]: expected the unit `m^2`, found `m`
   --> bodies.frob:9:14
    |
  2 |     area :: a -> Float[m^2]
    |             --------------- the signature of `area` requires `Float[m^2]`
  ...
  9 |     area s = 4 * s.side
    |              ^^^^^^^^^^ this is `Float[m]`
    |
    = hint: if the factor `4` has a unit, write it: `4[m]`
    = hint: if this is the right result, write the signature as `area :: a -> Float[m]`
  
  error[E0306]: the signature allows any type `b`, but the definition needs it to be `Square`
    --> bodies.frob:10:17
     |
   3 |     label :: a -> b -> b
     |              ----------- `b` is any type in the signature of `label`
  ...
  10 |     label s x = s
     |                 ^
     |
     = hint: if the definition is right, write the signature as `a -> Square -> Square`
  
  error[E0306]: the signature allows any type `a`, but the definition needs it to be `Float[m^2]`
    --> bodies.frob:15:19
     |
  12 | instance Shape a => Shape (Maybe a) where
     |                     -------------- `a` is any type in the instance of `Shape`
  ...
  15 |         Just x -> x
     |                   ^
  
  error[E0306]: the signature allows any type `b`, but the definition needs it to be `Float[m^2]`
    --> bodies.frob:16:17
     |
   3 |     label :: a -> b -> b
     |              ----------- `b` is any type in the signature of `label`
  ...
  16 |     label m x = area m
     |                 ^^^^^^
     |
     = hint: if the definition is right, write the signature as `a -> Float[m^2] -> Float[m^2]`
  
  error[E0302]: `area` has more than one parameter, but its type allows only one
    --> bodies.frob:19:12
     |
   2 |     area :: a -> Float[m^2]
     |             --------------- the signature of `area` requires `Bool -> Float[m^2]`
  ...
  19 |     area b c = 3
     |            ^
     |
     = hint: the signature needs a type for each parameter (`b`, `c`) and one for the result: `area :: … -> … -> …`
  
  5 errors
  [1]

Methods that are signal functions may run in the same places as other signal
functions.

  $ cat > levels.frob <<EOF
  > class HasSonar i where
  >     frontDistance :: SF i Distance
  >     near :: SF i Bool
  >     near = proc i -> if frontDistance i > 0 then True else False
  >     far :: i -> Bool
  >     far i = frontDistance i > 0
  > 
  > instance HasSonar (Maybe a) where
  >     frontDistance = proc m -> case m of
  >         Nothing -> 0
  >         Just x -> derivative 0
  >     far m = case m of
  >         Nothing -> True
  > 
  > use :: HasSonar i => SF i Distance
  > use = proc i -> y where
  >     y = if near i then frontDistance i else 0
  > EOF
  $ frobc check levels.frob
  error[E0341]: `frontDistance` is run outside of a `proc`
   --> levels.frob:6:13
    |
  6 |     far i = frontDistance i > 0
    |             ^^^^^^^^^^^^^^^ only a `proc` can run a signal function
    |
    = hint: run it in a `proc`, as in `f = proc x -> frontDistance x`; the type `a -> b` then becomes `SF a b`
  
  error[E0342]: `derivative` is run in a branch
    --> levels.frob:11:19
     |
  11 |         Just x -> derivative 0
     |                   ^^^^^^^^^^^^ its output depends on when it started
     |
     = hint: to run it at every instant, add the equation `derivativeNow = derivative 0`, and write `derivativeNow` here
     = hint: to restart it whenever this alternative is chosen, use `switch` to change between signal functions
  
  error[E0350]: this `case` does not cover every value
    --> levels.frob:12:18
     |
  12 |     far m = case m of
     |                  ^ there is no branch for `Just _`
     |
     = hint: add a branch `Just _ -> …`
  
  3 errors
  [1]
