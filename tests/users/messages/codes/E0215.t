  $ ../../explain/message.exe E0215
  main.frob:
  import Geometry (nrom)
  
  d :: Distance
  d = 2[m]
  
  error[E0215]: module `Geometry` has no `nrom` to import
   --> main.frob:1:18
    |
  1 | import Geometry (nrom)
    |                  ^^^^
    |
    = hint: did you mean `norm`?
  
  1 error
