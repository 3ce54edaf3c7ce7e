A loop through a signal function of the library is broken in the program's own module.

  $ cat > Filters.frob <<'FROB'
  > import qualified Control
  > 
  > smooth :: Float -> SF Float Float
  > smooth g = proc x -> y where
  >     y = before + g * (x - before)
  >     before = Control.previous y
  > FROB
  $ cat > main.frob <<'FROB'
  > import Filters
  > main = smooth 0.5
  > FROB
  $ frobc check main.frob
  error[E0401]: signal `y` needs its own value in the same instant
    --> Filters.frob:5:5
     |
   5 |     y = before + g * (x - before)
     |     ^   ------------------------- `y` reads `before` here
   6 |     before = Control.previous y
     |     --------------------------- `before` reads `y` here, through `previous`
     |
    ::: stdlib/Control.frob:44:5
     |
  44 |     y = if start then x else before
     |     - `previous` passes `x` on to this in the same instant
     |
    ::: main.frob:2:1
     |
   2 | main = smooth 0.5
     | ----------------- `smooth` runs here
     |
     = hint: let `before` read the previous value of `y`: `delay x0 y`, where `x0` is the initial value
  
  1 error
  [1]
