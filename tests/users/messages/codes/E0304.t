  $ ../../explain/message.exe E0304
  main.frob:
  halved :: SF Float Float
  halved = abs >>> derivative
  
  error[E0304]: expected a signal function, found a function: `n[u] -> n[u]`
   --> main.frob:2:10
    |
  2 | halved = abs >>> derivative
    |          ^^^ --- argument 1 of `>>>` is `SF a b`
    |
    = hint: use `arr` to turn a function into a signal function: `arr abs`
  
  1 error
