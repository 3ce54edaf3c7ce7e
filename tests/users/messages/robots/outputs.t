Outputs of robots.

Several commands at a time are composed:

  $ cat > two.frob <<'FROB'
  > import Create
  > import Robot
  > 
  > main :: Program CreateInput CreateOutput
  > main = reactimateRobot (proc _ -> roMake (setVelTR 0.3[m/s] 0, setLight On))
  > FROB
  $ frobc check two.frob
  error[E0301]: expected `a -> a`, found `(b -> b, c -> c)`
   --> two.frob:5:42
    |
  5 | main = reactimateRobot (proc _ -> roMake (setVelTR 0.3[m/s] 0, setLight On))
    |                                   ------ ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    |                                   |
    |                                   argument 1 of `roMake` is `o -> o`
    |
    = hint: compose functions with `.`: `setVelTR 0.3[m/s] 0 . setLight On`
  
  1 error
  [1]
  $ sed 's/ 0, setL/ 0 . setL/' two.frob > cured.frob
  $ frobc check cured.frob

A choice between the constructors of a type:

  $ cat > light.frob <<'FROB'
  > import Create
  > import Robot
  > 
  > main :: Program CreateInput CreateOutput
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 0 . setLight (bumped i)))
  > FROB
  $ frobc check light.frob
  error[E0301]: expected `Light`, found `Bool`
   --> light.frob:5:75
    |
  5 | main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 0 . setLight (bumped i)))
    |                                                                 --------  ^^^^^^^^
    |                                                                 |
    |                                                                 argument 1 of `setLight` is `Light`
    |
    = hint: use `Off` or `On`, as in `if bumped i then … else …`
  
  1 error
  [1]
  $ sed 's/(bumped i)/(if bumped i then On else Off)/' light.frob > cured.frob
  $ frobc check cured.frob

A sensor function without its input:

  $ cat > bumped.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateRobot (proc i -> roMake (setVelTR (if bumped then 0 else 0.2[m/s]) 0))
  > FROB
  $ frobc check bumped.frob
  error[E0301]: expected `Bool`, found the function `a -> Bool`
   --> bumped.frob:3:56
    |
  3 | main = reactimateRobot (proc i -> roMake (setVelTR (if bumped then 0 else 0.2[m/s]) 0))
    |                                                        ^^^^^^
    |
    = hint: write `bumped i`
  
  1 error
  [1]
  $ sed 's/if bumped/if bumped i/' bumped.frob > cured.frob
  $ frobc check cured.frob
