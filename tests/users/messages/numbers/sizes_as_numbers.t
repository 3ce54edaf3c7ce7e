A size variable of a signature has no value. The message says how to compute the number:

  $ cat > sizes.frob <<'FROB'
  > import Matrix
  > 
  > middle :: Array n Float -> Float
  > middle xs = at (n `div` 2) 0 xs
  > 
  > scaled :: Matrix r c -> Float
  > scaled a = sum (map sum a) / toFloat (r * c)
  > 
  > main :: SF (Array 3 Float) (Float, Float)
  > main = proc xs -> (middle xs, scaled [xs])
  > FROB
  $ frobc check sizes.frob
  error[E0205]: unknown name `n`
   --> sizes.frob:4:17
    |
  4 | middle xs = at (n `div` 2) 0 xs
    |                 ^
    |
    = hint: `n` is a size in the type of `middle`: to use it as a number, write `length xs`
  
  error[E0205]: unknown name `r`
   --> sizes.frob:7:39
    |
  7 | scaled a = sum (map sum a) / toFloat (r * c)
    |                                       ^
    |
    = hint: `r` is a size in the type of `scaled`: to use it as a number, write `length a`
  
  error[E0205]: unknown name `c`
   --> sizes.frob:7:43
    |
  7 | scaled a = sum (map sum a) / toFloat (r * c)
    |                                           ^
    |
    = hint: `c` is a size in the type of `scaled`: to use it as a number, write `length (a ! 0)`
  
  3 errors
  [1]
  $ frobc fix --all sizes.frob
  sizes.frob:4:17: write `(length xs)` (E0205)
  sizes.frob:7:39: write `(length a)` (E0205)
  sizes.frob:7:43: write `(length (a ! 0))` (E0205)
  $ grep '^middle xs' sizes.frob
  middle xs = at ((length xs) `div` 2) 0 xs

A definition, a variable or a type with this name is something else:

  $ cat > others.frob <<'FROB'
  > n :: Int
  > n = 2
  > 
  > double :: Array n Float -> Int -> Int
  > double xs k = n * k * length xs
  > 
  > main :: SF (Array 3 Float) Int
  > main = proc xs -> double xs 2
  > FROB
  $ frobc check others.frob
