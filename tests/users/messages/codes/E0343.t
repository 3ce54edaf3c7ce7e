  $ ../../explain/message.exe E0343
  main.frob:
  twice :: SF Float Float
  twice = proc x -> f x where
      f y = y + delay 0.0 x
  
  error[E0343]: `delay` is run in the function `f`
   --> main.frob:3:15
    |
  3 |     f y = y + delay 0.0 x
    |               ^^^^^^^^^^^ a function cannot run a signal function, because a signal function has state: run it in a `proc`
    |
    = hint: to run it at every instant, add the equation `delayNow = delay 0.0 x`, and write `delayNow` here
  
  1 error
