  $ ../../explain/message.exe E0236
  lost.test.frob:
  test "waits for two seconds" = during 2[s] waiting
  
  error[E0236]: this is a test file, but the program `lost.frob` does not exist
   --> lost.test.frob:1:1
    |
  1 | test "waits for two seconds" = during 2[s] waiting
    | ^
    |
    = hint: put the tests of `NAME.frob` into `NAME.test.frob` in the same folder
  
  1 error
