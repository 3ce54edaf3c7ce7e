  $ ../../explain/message.exe W0303
  main.frob:
  main :: SF Float Float
  main = proc x -> x * cos 90
  
  warning[W0303]: this angle is in radians, so it is more than a whole turn
   --> main.frob:2:26
    |
  2 | main = proc x -> x * cos 90
    |                          ^^
    |
    = hint: if you meant degrees, write `90[deg]`
  
  1 warning
