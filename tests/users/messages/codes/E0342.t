  $ ../../explain/message.exe E0342
  main.frob:
  way :: SF (Bool, Velocity) Distance
  way = proc (b, v) -> if b then integral v else 0
  
  error[E0342]: `integral` is run in a branch
   --> main.frob:2:32
    |
  2 | way = proc (b, v) -> if b then integral v else 0
    |                                ^^^^^^^^^^ its output depends on when it started
    |
    = hint: to run it at every instant, add the equation `integralNow = integral v`, and write `integralNow` here
    = hint: to restart it whenever this branch is chosen, write `integralNow = resetOn integral (v, edge b)`
    = hint: to pause it while this branch is not chosen, write `integral (if b then v else 0)` in place of the whole `if`
  
  1 error
