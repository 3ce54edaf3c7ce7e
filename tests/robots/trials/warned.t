A program with a warning, whose test does not compile: the warning is reported once.

  $ cat > loop.frob << 'FROB'
  > import Trial
  > 
  > main :: SF Float Float
  > main = proc x -> x
  > 
  > loop :: SF Float Float
  > loop = proc x -> y where
  >     z = 1
  >     y = y + x
  > 
  > test "never goes on" = during 1[s] (proc () -> loop 2 > 1)
  > FROB
  $ frobc test loop.frob
  warning[W0304]: `z` is defined here, but nothing uses it
   --> loop.frob:8:5
    |
  8 |     z = 1
    |     ^
    |
    = hint: use it in an output, or remove it; if it is unused on purpose, rename it to `_z`
  
  1 warning
  error[E0401]: the signal `y` needs its own value in the same instant
   --> loop.frob:9:5
    |
  9 |     y = y + x
    |     ^   ----- `y` reads `y` here
    |
    = hint: let `y` read its own previous value: write `y = delay 0 y + x`, where 0 is the initial value
  
  1 error
  FAIL  never goes on: does not compile
  1 test: 1 failed
  [1]
