  $ ../../explain/message.exe W0305
  main.frob:
  clampTo :: Float -> Float -> Float
  clampTo low x = max 0 x
  
  warning[W0305]: `low` is never used
   --> main.frob:2:9
    |
  2 | clampTo low x = max 0 x
    |         ^^^
    |
    = hint: use it in the definition; if it is unused on purpose, replace it with `_` or `_low`
  
  1 warning
