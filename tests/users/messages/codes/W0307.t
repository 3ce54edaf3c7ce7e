  $ ../../explain/message.exe W0307
  main.frob:
  main :: SF Float Float
  main = proc x -> x * acos 1.5
  
  warning[W0307]: this is always NaN (not a number)
   --> main.frob:2:22
    |
  2 | main = proc x -> x * acos 1.5
    |                      ^^^^^^^^
    |
    = note: every comparison with NaN is False, and every result computed from NaN is NaN
  
  1 warning
