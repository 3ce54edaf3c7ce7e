Numbers out of the range of Int, if the numbers of a definition are Ints only because of its use.

  $ cat > definition.frob <<'FROB'
  > big = 100000 * 100000
  > main :: SF Int Int
  > main = proc x -> x + big
  > FROB
  $ frobc check definition.frob
  warning[W0308]: this is 10000000000, which is out of range for an `Int`: it wraps around to 1410065408
   --> definition.frob:3:22
    |
  3 | main = proc x -> x + big
    |                      ^^^
    |
    = note: an `Int` must be between -2147483648 and 2147483647
    = hint: use Floats, or a larger unit
  
  1 warning

  $ cat > function.frob <<'FROB'
  > sq :: n[1] -> n[1]
  > sq x = x * x
  > main :: SF Int Int
  > main = proc x -> x + sq 100000
  > FROB
  $ frobc check function.frob
  warning[W0308]: this is 10000000000, which is out of range for an `Int`: it wraps around to 1410065408
   --> function.frob:4:22
    |
  4 | main = proc x -> x + sq 100000
    |                      ^^^^^^^^^
    |
    = note: an `Int` must be between -2147483648 and 2147483647
    = hint: use Floats, or a larger unit
  
  1 warning
