  $ ../../explain/message.exe W0304
  main.frob:
  import Robot
  
  main = reactimateRobot (proc i -> roMake (setVelTR v 0[1/s]) where
      stop = bumped i
      v = 0.2[m/s])
  
  warning[W0304]: `stop` is defined here, but nothing uses it
   --> main.frob:4:5
    |
  4 |     stop = bumped i
    |     ^^^^
    |
    = hint: use it in an output, or remove it; if it is unused on purpose, rename it to `_stop`
  
  1 warning
