  $ ../../explain/message.exe E0103
  main.frob:
  ω :: Float
  ω = 0.5
  
  error[E0103]: unexpected character `ω`
   --> main.frob:1:1
    |
  1 | ω :: Float
    | ^
    |
    = hint: use only `a`–`z`, `A`–`Z`, digits, `_` and `'` in names
  
  error[E0103]: unexpected character `ω`
   --> main.frob:2:1
    |
  2 | ω = 0.5
    | ^
    |
    = hint: use only `a`–`z`, `A`–`Z`, digits, `_` and `'` in names
  
  2 errors
