  $ ../../explain/message.exe E0201
  main.frob:
  import Robott
  
  speed :: SF RobotInput Velocity
  speed = velocity
  
  error[E0201]: there is no module `Robott`
   --> main.frob:1:8
    |
  1 | import Robott
    |        ^^^^^^
    |
    = note: frobc looked for `Robott.frob` in the folder of this file and in the library
    = hint: did you mean `Robot`?
  
  1 error
