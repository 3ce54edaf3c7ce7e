A signal function as a step of a task.

  $ cat > proc.frob <<'FROB'
  > import Robot
  > 
  > main = reactimateTask (do
  >     forward 1[m]
  >     proc _ -> roMake (setVelTR 0.1[m/s] 0)
  >     turnBy 90[deg])
  > FROB
  $ frobc check proc.frob
  error[E0371]: a signal function stands where a task is needed
   --> proc.frob:5:5
    |
  3 | main = reactimateTask (do
    |        -------------- so each task of this `do` is `Task a b c`
  4 |     forward 1[m]
  5 |     proc _ -> roMake (setVelTR 0.1[m/s] 0)
    |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this is `SF d e`
    |
    = hint: a task ends at an event, which its `proc` gives beside the output: `mkTask (proc _ -> (roMake (setVelTR 0.1[m/s] 0), after 1[s] ()))`; one with `never ()` in that place goes on for ever
  
  1 error
  [1]
  $ sed 's/proc _ -> \(.*\)/mkTask (proc _ -> (\1, after 1[s] ()))/' proc.frob > cured.frob
  $ frobc check cured.frob
