  $ ../../explain/message.exe E0106
  main.frob: 20007 bytes
  
  error[E0106]: this is nested more than 10000 levels deep
   --> main.frob:1:10004
    |
  1 | …((((((((((((((((((((((((((((((((((((((((((1)))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))…
    |                                          ^
    |
    = hint: move inner parts into definitions of their own
  
  1 error
