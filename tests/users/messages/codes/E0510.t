  $ ../../explain/message.exe E0510
  main.frob:
  import Ros
  
  -- | The distance to the wall.
  data Wall = Wall { distance :: Int }
  
  instance Message Wall where
      rosType _ = "std_msgs/msg/Float64"
  
  data In = In { wall :: Event Wall }
  
  main :: Program In ()
  main = node 50[Hz] (constant ())
  
  error[E0510]: std_msgs/msg/Float64 has no field for `distance` of `Wall`
   --> main.frob:4:20
    |
  4 | data Wall = Wall { distance :: Int }
    |                    ^^^^^^^^
    |
    = hint: remove it, or give it the name of one of the message's fields: data_
  
  1 error
