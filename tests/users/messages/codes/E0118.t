  $ ../../explain/message.exe E0118
  main.frob:
  speed :: Float
  speed = limit 0.4 1
  
  import Control
  
  error[E0118]: an `import` must come before all definitions
   --> main.frob:4:1
    |
  4 | import Control
    | ^^^^^^^^^^^^^^
    |
    = hint: move it to the top of the file
  
  1 error
