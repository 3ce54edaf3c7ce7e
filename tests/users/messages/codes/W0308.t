  $ ../../explain/message.exe W0308
  main.frob:
  main :: SF Int Int
  main = proc n -> n + 1000 * 1000 * 1000 * 3
  
  warning[W0308]: this is 3000000000, which is out of range for an `Int`: it wraps around to -1294967296
   --> main.frob:2:22
    |
  2 | main = proc n -> n + 1000 * 1000 * 1000 * 3
    |                      ^^^^^^^^^^^^^^^^^^^^^^
    |
    = note: an `Int` must be between -2147483648 and 2147483647
    = hint: use Floats, or a larger unit
  
  1 warning
