  $ ../../explain/message.exe E0303
  main.frob:
  late :: SF () Bool
  late = proc () -> time > 10[s]
  
  error[E0303]: expected a value, found a signal function that is not applied to a signal
   --> main.frob:2:19
    |
  2 | late = proc () -> time > 10[s]
    |                   ^^^^   ----- this is a number in `s`
    |                   |
    |                   this is `SF a Time`
    |
    = hint: run the signal function on `()`: `time ()`
  
  1 error
