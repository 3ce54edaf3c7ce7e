A camera in ROS 2: here with the fake ROS 2, whose camera sees only red, so all its frames
are identical.

  $ . ./ros.sh
  $ cat >red.frob <<END
  > import Robot
  > import Vision
  > red :: ColourRange
  > red = ColourRange { hueFrom = -10[deg], hueTo = 10[deg], saturationFrom = 0.8, saturationTo = 1, valueFrom = 0.5, valueTo = 1 }
  > main :: (HasCamera i, DiffDrive o) => Program i o
  > main = reactimateRobot (proc i -> roMake (setVelTR (hold 0 (mapE (\f -> if (findBlob f.image (everywhere f.image) red).pixels == 1200 then 0.2[m/s] else 0.1[m/s]) (camera i))) 0))
  > END
  $ speeds="0 0.2 0"; faults=
  $ run_ros red.frob --for 1s --set camera.frozen=0; cat messages velocities
  warning: the instants of red are not published, because they contain images; use --record
  0.000 0.000
  0.200 0.000
  0.000 0.000

Another topic, and another name of the node:

  $ run_ros red.frob --for 1s --set camera.frozen=0 --camera ros:front/image --ros-args -r __node:=eye --; cat messages
  warning: the instants of red are not published, because they contain images; use --record

An encoding that is not supported:

  $ faults=yuv=0 speeds=""; FAKE_ROS=$faults frobc run --ros2 red.frob $patient --for 1s 2>&1 >summary | grep encoding
  warning: an image on /image_raw is ignored: its encoding is not rgb8, bgr8 or mono8, but yuv422
