For a loop through a signal function of the library, the message says how to break it in the
program's own module.

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
  $ frobc check main.frob > said 2>&1
  [1]

Removes the line number in the library, which does not matter here.

  $ sed 's/Control.frob:[0-9]*/Control.frob:N/; s/^[0-9]* | previous/ N | previous/' said
  error[E0401]: the signal `y` needs its own value in the same instant
    --> Filters.frob:5:5
     |
   5 |     y = before + g * (x - before)
     |     ^   ------------------------- `y` reads `before` here
   6 |     before = Control.previous y
     |     --------------------------- `before` reads `y` here, through `previous`
     |
    ::: stdlib/Control.frob:N:22
     |
   N | previous = proc x -> fromMaybe x (delay Nothing (Just x))
     |                      ------------------------------------ `previous` passes `x` to this output in the same instant
     |
    ::: main.frob:2:1
     |
   2 | main = smooth 0.5
     | ----------------- `smooth` runs here
     |
     = hint: let `before` read the previous value of `y`: add the equation `earlier = delay 0 y`, where 0 is the initial value, and read `earlier` here
  
  1 error
