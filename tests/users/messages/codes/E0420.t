  $ ../../explain/message.exe E0420
  main.frob:
  blink :: Float -> Task Float Float ()
  blink level = do
      sleepT 1[s] level
      blink (level + 1)
      sleepT 1[s] 0
  
  main :: SF Float (Either Float ())
  main = runTask (blink 1)
  
  error[E0420]: a task restarts itself, but not as its last statement
   --> main.frob:4:5
    |
  4 |     blink (level + 1)
    |     ^^^^^^^^^^^^^^^^^ it restarts here
  5 |     sleepT 1[s] 0
    |     ------------- this waits for the restarted task to end
    |
    = note: each restart would leave one more statement waiting, but memory is fixed
    = hint: make `blink` the last statement, or move the waiting statements into the branch that ends the task; to repeat a task, write `repeatT 4 t` or `forever t`
  
  1 error
