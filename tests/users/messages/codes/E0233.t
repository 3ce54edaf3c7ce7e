  $ ../../explain/message.exe E0233
  main.frob:
  foreign sf tracker :: SF Float Float = "tracker"
  
  error[E0233]: no included C header defines `struct tracker_state`
   --> main.frob:1:12
    |
  1 | foreign sf tracker :: SF Float Float = "tracker"
    |            ^^^^^^^
    |
    = note: it is part of the program's state, so the C compiler must know its size
    = hint: include the header in this module, as in `foreign include "blob.h"`
  
  1 error
