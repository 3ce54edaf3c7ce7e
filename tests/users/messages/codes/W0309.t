  $ ../../explain/message.exe W0309
  main.frob:
  import Control
  
  main :: SF Bool Bool
  main = debounce (-0.2[s])
  
  warning[W0309]: `debounce` has a negative time, which counts as zero
   --> main.frob:4:18
    |
  4 | main = debounce (-0.2[s])
    |                  ^^^^^^^
    |
    = hint: write a time of at least `0[s]`
  
  1 warning
