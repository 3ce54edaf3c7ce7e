  $ ../../explain/message.exe W0313
  main.frob:
  import Geometry
  
  main :: SF Pose Bool
  main = proc pose -> pose.heading * 180 / pi < 90[deg]
  
  warning[W0313]: this is in degrees, but angles are in radians
   --> main.frob:4:21
    |
  4 | main = proc pose -> pose.heading * 180 / pi < 90[deg]
    |                     ^^^^^^^^^^^^^^^^^^^^^^^   ------- `90[deg]` is in radians
    |
    = hint: remove the conversion, because `90[deg]` is in radians too: write `pose.heading`
  
  1 warning
