  $ ../../explain/message.exe W0201
  main.frob:
  scale :: Float -> Float -> Float
  scale k x = k * (let k = 2 in k * x)
  
  warning[W0201]: `k` hides a local variable of the same name
   --> main.frob:2:22
    |
  2 | scale k x = k * (let k = 2 in k * x)
    |       -              ^
    |       |
    |       this variable is hidden
  
  1 warning
