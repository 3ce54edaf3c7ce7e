  $ ../../explain/message.exe E0431
  main.frob:
  foreign include "main_in_c.h"
  
  foreign sf control :: SF Float Float = "main"
  
  main :: SF Float Float
  main = control
  
  error[E0431]: the program and the C component `main` have the same name
   --> main.frob:3:12
    |
  3 | foreign sf control :: SF Float Float = "main"
    |            ^^^^^^^
    |
    = note: both would define `struct main_state`, `main_reset` and `main_step`
    = hint: rename the program's file
  
  1 error
