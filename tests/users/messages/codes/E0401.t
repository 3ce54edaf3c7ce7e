  $ ../../explain/message.exe E0401
  main.frob:
  main :: SF Float Float
  main = proc target -> speed where
      err   = target - speed
      speed = 0.5 * err
  
  error[E0401]: the signal `err` needs its own value in the same instant
   --> main.frob:3:5
    |
  3 |     err   = target - speed
    |     ^^^     -------------- `err` reads `speed` here
  4 |     speed = 0.5 * err
    |             --------- `speed` reads `err` here
    |
    = hint: let `speed` read the previous value of `err`: write `speed = 0.5 * delay 0 err`, where 0 is the initial value
  
  1 error
