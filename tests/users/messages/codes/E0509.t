  $ ../../explain/message.exe E0509
  main.frob:
  import Ros
  
  data In = In { goal :: Maybe Pose3 }
  data Out = Out { cmdVel :: Twist }
  
  main :: Program In Out
  main = node 50[Hz] (proc _ -> Out { cmdVel = twist 0 0 })
  
  error[E0509]: the field `goal` of `In` is not a topic: `Maybe Pose3` is not a message type
   --> main.frob:3:24
    |
  3 | data In = In { goal :: Maybe Pose3 }
    |                        ^^^^^^^^^^^
    |
    = hint: use Bool, Int, Float, an enumeration with an instance of `RosText`, or a record with an instance of `Message`, such as those in the module Ros; `frobc ros2 import PACKAGE/Type` writes the record for any other message
  
  1 error
