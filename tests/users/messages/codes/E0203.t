  $ ../../explain/message.exe E0203
  main.frob:
  module Prelude where
  
  gain :: Float
  gain = 2.0
  
  error[E0203]: two modules are named `Prelude`: `main.frob` and `stdlib/Prelude.frob`
   --> main.frob:1:1
    |
  1 | module Prelude where
    | ^
    |
    = hint: give your own module another name
  
  1 error
