  $ ../../explain/message.exe E0202
  main.frob:
  module Gains where
  
  import Gains
  
  gain :: Float
  gain = 2.0
  
  error[E0202]: modules import each other: `Gains` → `Gains`
   --> main.frob:3:8
    |
  3 | import Gains
    |        ^^^^^
  
  1 error
