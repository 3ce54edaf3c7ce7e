  $ ../../explain/message.exe E0104
  main.frob:
  speed :: Float
  speed = 0.4
  {- slower on carpet {- and on tiles -}
  
  error[E0104]: this comment is never closed
   --> main.frob:3:1
    |
  3 | {- slower on carpet {- and on tiles -}
    | ^^
    |
    = hint: close it with `-}`; comments nest, so each `{-` needs its own `-}`
  
  1 error
