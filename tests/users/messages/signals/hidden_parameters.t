A local name that hides a parameter: setting that would change nothing there.

  $ cat > gain.frob <<'FROB'
  > param gain :: Float = 0.5
  > param offset :: Float = 1
  > 
  > main :: SF Float Float
  > main = proc x -> y where
  >     gain = 2 * x
  >     y = gain + scaled x
  > 
  > scaled :: Float -> Float
  > scaled offset = offset * offset
  > 
  > other :: Float -> Float
  > other x = x + offset
  > FROB
  $ frobc check gain.frob
  warning[W0201]: `gain` hides the parameter of that name
   --> gain.frob:6:5
    |
  1 | param gain :: Float = 0.5
    |       ---- what is set when a run starts does not matter there
  ...
  6 |     gain = 2 * x
    |     ^^^^
    |
    = hint: give one of them another name
  
  warning[W0201]: `offset` hides the parameter of that name
    --> gain.frob:10:8
     |
   2 | param offset :: Float = 1
     |       ------ what is set when a run starts does not matter there
  ...
  10 | scaled offset = offset * offset
     |        ^^^^^^
     |
     = hint: give one of them another name
  
  2 warnings
