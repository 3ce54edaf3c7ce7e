  $ ../../explain/message.exe E0101
  main.frob:
  -- a café on the way
  speed :: Float
  speed = 0.4
  
  error[E0101]: this file is not valid UTF-8: byte 233 is not allowed here
   --> main.frob:1:9
    |
  1 | -- a cafï¿½ on the way
    |         ^
    |
    = hint: save the file as UTF-8 text
  
  1 error
