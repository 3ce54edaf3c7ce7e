  $ ../../explain/message.exe E0506
  main.frob:
  main :: SF Velocity Velocity
  main = proc v -> 2 * v + 1[m/s]
  
  error[E0506]: this program has no inner signal `speed`
   --> main.frob:2:1
    |
  2 | main = proc v -> 2 * v + 1[m/s]
    | ^^^^
    |
    = hint: `--probe list` lists all inner signals
  
  1 error
