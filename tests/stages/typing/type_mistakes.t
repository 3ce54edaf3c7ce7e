Numbers of another representation: the messages name the conversions.

  $ cat > numbers.frob <<FROB
  > count :: Int
  > count = 3.5
  > 
  > mean :: Int -> Float
  > mean n = toFloat n / 2 + n
  > FROB
  $ frobc check numbers.frob
  error[E0312]: expected `Int`, found `Float`
   --> numbers.frob:2:9
    |
  1 | count :: Int
    |          --- the signature of `count` requires `Int`
  2 | count = 3.5
    |         ^^^
    |
    = hint: write `round 3.5`, or use `floor`, `ceiling` or `truncate` instead of `round`
  
  error[E0312]: the operands of `+` are `Float` and `Int`
   --> numbers.frob:5:26
    |
  5 | mean n = toFloat n / 2 + n
    |          -------------   ^ this is `Int`
    |          |
    |          this is `Float`
    |
    = hint: write `toFloat n`
  
  2 errors
  [1]

Fields are looked up in the record's type; similar names are suggested.

  $ cat > fields.frob <<FROB
  > import Geometry
  > 
  > course :: Pose -> Angle
  > course p = p.headng
  > 
  > away p = p.positio
  > 
  > turned :: Pose -> Pose
  > turned p = p { heading = 1[m] }
  > 
  > flat v = v.x
  > FROB
  $ frobc check fields.frob
  error[E0310]: `Pose` has no field `headng`
   --> fields.frob:4:14
    |
  4 | course p = p.headng
    |            - ^^^^^^
    |            |
    |            this is `Pose`
    |
    = hint: did you mean `heading`?
  
  error[E0310]: no type in scope has a field `positio`
   --> fields.frob:6:12
    |
  6 | away p = p.positio
    |            ^^^^^^^
    |
    = hint: did you mean `position`?
  
  error[E0320]: expected no unit, found `m`
   --> fields.frob:9:26
    |
  9 | turned p = p { heading = 1[m] }
    |                -------   ^^^^ this is `Float[m]`
    |                |
    |                the field `heading` is `Angle` (1)
  
  error[E0311]: several types have a field `x`, and nothing determines which one you mean
    --> fields.frob:11:12
     |
  11 | flat v = v.x
     |          - ^
     |          |
     |          the type of this is unknown
     |
     = note: types with such a field: `Vec2`, `Vec3`
     = hint: give the definition a signature
  
  4 errors
  [1]

Types that cannot be compared, types that nothing determines, and signatures
that lack something.

  $ cat > comparisons.frob <<FROB
  > same = sin == cos
  > 
  > quiet = NoEvent == NoEvent
  > 
  > either3 :: a -> a -> Bool
  > either3 x y = x == y
  > FROB
  $ frobc check comparisons.frob
  error[E0307]: `Angle -> Float` has no equality
   --> comparisons.frob:1:12
    |
  1 | same = sin == cos
    |            ^^ `==` needs it
  
  error[E0308]: nothing determines the type at which `==` is used
   --> comparisons.frob:3:17
    |
  3 | quiet = NoEvent == NoEvent
    |                 ^^
    |
    = note: the type must have an instance of the class `Eq`
    = hint: add a type annotation, as in `(e :: T)`
  
  error[E0309]: `==` needs `Eq a`, which the signature of `either3` does not declare
   --> comparisons.frob:6:17
    |
  5 | either3 :: a -> a -> Bool
    |            -------------- the signature of `either3`
  6 | either3 x y = x == y
    |                 ^^
    |
    = hint: write `Eq a => a -> a -> Bool`
  
  3 errors
  [1]

A signature that is more general than the definition.

  $ cat > promises.frob <<FROB
  > next :: a -> a
  > next x = x + 1
  > 
  > half :: n[u] -> n[u]
  > half x = x / 2.0
  > 
  > swap :: (a, b) -> (a, b)
  > swap (x, y) = (y, x)
  > FROB
  $ frobc check promises.frob
  error[E0306]: the signature allows any type `a`, but the definition needs it to be a number
   --> promises.frob:2:10
    |
  1 | next :: a -> a
    |         ------ `a` is any type in the signature of `next`
  2 | next x = x + 1
    |          ^
  
  error[E0306]: the signature allows any representation `n`, but the definition needs it to be `Float`
   --> promises.frob:5:10
    |
  4 | half :: n[u] -> n[u]
    |         ------------ `n` is any representation in the signature of `half`
  5 | half x = x / 2.0
    |          ^
    |
    = hint: if the definition is right, write the signature as `Float[u] -> Float[u]`
  
  error[E0301]: the two parts of this pair are in the wrong order
   --> promises.frob:8:15
    |
  7 | swap :: (a, b) -> (a, b)
    |         ---------------- the signature of `swap` requires `(a, b)`
  8 | swap (x, y) = (y, x)
    |               ^^^^^^
    |
    = hint: write `(x, y)`, or swap their types in the signature
  
  3 errors
  [1]

Patterns, conditions, and a function applied to itself.

  $ cat > shapes.frob <<FROB
  > value e = case e of
  >   Just x -> x
  >   True -> 1
  > 
  > choose = if 1 then 2 else 3
  > 
  > pair = a where
  >   (a, b) = (1.0, 2.0, 3.0)
  > 
  > itself f = f f
  > FROB
  $ frobc check shapes.frob
  error[E0301]: this pattern matches `Bool`, but the value is `Maybe a`
   --> shapes.frob:3:3
    |
  1 | value e = case e of
    |                - the value is `Maybe a`
  2 |   Just x -> x
  3 |   True -> 1
    |   ^^^^
  
  error[E0301]: a condition must be `Bool`, but this is a number
   --> shapes.frob:5:13
    |
  5 | choose = if 1 then 2 else 3
    |             ^
    |
    = hint: use `True`: a number is not a `Bool`
  
  error[E0301]: expected a tuple with 2 elements, found one with 3
   --> shapes.frob:8:12
    |
  8 |   (a, b) = (1.0, 2.0, 3.0)
    |   ------   ^^^^^^^^^^^^^^^
    |   |
    |   the pattern matches `(a, b)`
    |
    = hint: write the pattern as `(a, b, c)`
  
  error[E0305]: this would need an infinite type: expected `a -> b`, found `a`
    --> shapes.frob:10:12
     |
  10 | itself f = f f
     |        -   ^
     |        |
     |        `f` is bound here
  
  4 errors
  [1]
