  $ ../../explain/message.exe W0306
  main.frob:
  import Control
  import Geometry
  
  main :: SF Float Float
  main = lowPass 0.5[s]
  
  warning[W0306]: `Geometry` is imported, but nothing from it is used
   --> main.frob:2:1
    |
  2 | import Geometry
    | ^^^^^^^^^^^^^^^
    |
    = hint: remove it
  
  1 warning
