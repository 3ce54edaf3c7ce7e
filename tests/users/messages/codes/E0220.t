  $ ../../explain/message.exe E0220
  main.frob:
  unit q = 0.25 m
  
  error[E0220]: the name of the unit `q` is a single lower-case letter
   --> main.frob:1:6
    |
  1 | unit q = 0.25 m
    |      ^
    |
    = note: single lower-case letters are reserved for unit variables and the library's units
    = hint: use a name of at least two characters, or a capital letter
  
  1 error
