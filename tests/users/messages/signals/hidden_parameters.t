An equation with the name of a parameter: setting the parameter would not change the equation. An
argument of a function may still be the parameter.

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
  warning[W0201]: `gain` hides the parameter of the same name
   --> gain.frob:6:5
    |
  1 | param gain :: Float = 0.5
    |       ---- setting this parameter has no effect where it is hidden
  ...
  6 |     gain = 2 * x
    |     ^^^^
    |
    = hint: give one of them another name
  
  1 warning
