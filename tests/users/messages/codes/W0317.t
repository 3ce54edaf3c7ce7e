  $ ../../explain/message.exe W0317
  main.frob:
  -- | Twice the number. Deprecated: renamed to `doubled`.
  twice :: Float -> Float
  twice = doubled
  
  -- | Twice the number.
  doubled :: Float -> Float
  doubled x = 2 * x
  
  main :: SF Float Float
  main = proc x -> twice x
  
  warning[W0317]: `twice` is deprecated
    --> main.frob:10:18
     |
  10 | main = proc x -> twice x
     |                  ^^^^^
     |
     = hint: write `doubled`, its new name
  
  1 warning
