  $ ../../explain/message.exe E0341
  main.frob:
  smooth x = delay 0.0 x
  
  error[E0341]: `delay` is run outside of a `proc`
   --> main.frob:1:12
    |
  1 | smooth x = delay 0.0 x
    |            ^^^^^^^^^^^ only a `proc` can run a signal function
    |
    = hint: run it in a `proc`: `smooth = proc x -> delay 0.0 x`; the type `a -> b` then becomes `SF a b`
  
  1 error
