  $ ../../explain/message.exe E0501
  main.frob:
  import Control
  
  smooth :: SF Float Float
  smooth = lowPass 0.1[s]
  
  error[E0501]: this module has no `main` to compile
   --> main.frob:1:1
    |
  1 | import Control
    | ^
    |
    = hint: define `main`, or name a signal function of this module with `--entry NAME`
  
  1 error
