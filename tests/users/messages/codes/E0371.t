  $ ../../explain/message.exe E0371
  main.frob:
  slow :: SF Float Float
  slow = proc x -> 0.1 * x
  
  main :: SF Float (Either Float ())
  main = runTask (do
      slow
      sleepT 1[s] 0)
  
  error[E0371]: expected a task, found a signal function
   --> main.frob:6:5
    |
  5 | main = runTask (do
    |        ------- each task of this `do` must be `Task a b c`
  6 |     slow
    |     ^^^^ this is `SF Float Float`
    |
    = hint: to read it once, write `ask slow`
    = hint: to run it for a fixed time, write `mkTask (slow &&& after 5[s])`; to run it forever, `mkTask (slow &&& never)`
  
  1 error
