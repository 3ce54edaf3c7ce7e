Semicolons, several commands, and a signature of too few parameters: one message each.

  $ cat > tasks.frob <<'FROB'
  > import Robot
  > main = reactimateTask (forward 1[m]; turnBy 90[deg])
  > FROB
  $ frobc check tasks.frob
  error[E0111]: this `(` is never closed
   --> tasks.frob:2:23
    |
  2 | main = reactimateTask (forward 1[m]; turnBy 90[deg])
    |                       ^            - a `)` is missing before this
    |
    = hint: a `;` ends a definition: write each task on its own line of a `do`
  
  1 error
  [1]

  $ cat > elements.frob <<'FROB'
  > main :: SF Float (Array 3 Float)
  > main = proc x -> [x; x; x]
  > FROB
  $ frobc check elements.frob
  error[E0111]: separate array elements with `,`, not `;`
   --> elements.frob:2:20
    |
  2 | main = proc x -> [x; x; x]
    |                    ^
    |
    = hint: write `[x, x, x]`
  
  1 error
  [1]

  $ cat > commands.frob <<'FROB'
  > import Robot
  > main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 0) (setLight On))
  > FROB
  $ frobc check commands.frob
  error[E0360]: `roMake` takes one function, and turns it into an output
     --> commands.frob:2:35
      |
    2 | main = reactimateRobot (proc i -> roMake (setVelTR 0.2[m/s] 0) (setLight On))
      |                                   ^^^^^^ `roMake` needs it
      |
     ::: stdlib/Capability.frob:216:11
      |
  216 | roMake :: RobotOutput o => (o -> o) -> o
      |           ------------------------------ `roMake` requires `RobotOutput o` here
      |
      = hint: combine several commands with `.`: `roMake (setVelTR v omega . setLight On)`
  
  1 error
  [1]

  $ cat > parameters.frob <<'FROB'
  > steer :: Float -> Float
  > steer a b = a - b
  > main :: SF Float Float
  > main = proc x -> steer x 1
  > FROB
  $ frobc check parameters.frob
  error[E0302]: `steer` has more than one parameter, but its type allows only one
   --> parameters.frob:2:9
    |
  1 | steer :: Float -> Float
    |          -------------- the signature of `steer` requires `Float -> Float`
  2 | steer a b = a - b
    |         ^
    |
    = hint: the signature needs a type for each parameter (`a`, `b`) and one for the result: `steer :: … -> … -> …`
  
  1 error
  [1]

  $ cat > beginning.frob <<'FROB'
  > main :: SF Velocity Distance
  > main = proc v -> integral 5[m] v
  > FROB
  $ frobc check beginning.frob
  error[E0302]: `integral` takes 1 argument, but is given 2
   --> beginning.frob:2:32
    |
  2 | main = proc v -> integral 5[m] v
    |                  --------      ^ one too many
    |                  |
    |                  with one argument, its result is `Float[m s]`
    |
    = hint: `integral` starts at 0: for another initial value, write `5[m] + integral v`; to restart it when an event occurs, write `resetOn integral (v, e)`
  
  1 error
  [1]
