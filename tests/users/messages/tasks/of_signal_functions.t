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
  error[E0371]: expected a task, found a signal function
   --> proc.frob:5:5
    |
  3 | main = reactimateTask (do
    |        -------------- each task of this `do` must be `Task a b c`
  4 |     forward 1[m]
  5 |     proc _ -> roMake (setVelTR 0.1[m/s] 0)
    |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this is `SF d e`
    |
    = hint: add the event that ends the task: `mkTask (proc _ -> (roMake (setVelTR 0.1[m/s] 0), after 1[s] ()))`; with `never ()` as the event, it never ends
  
  1 error
  [1]
  $ sed 's/proc _ -> \(.*\)/mkTask (proc _ -> (\1, after 1[s] ()))/' proc.frob > cured.frob
  $ frobc check cured.frob
