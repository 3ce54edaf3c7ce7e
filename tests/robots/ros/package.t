`frobc export --ros2` writes a package for `colcon build`.

  $ . ./ros.sh
  $ frobc export drive.frob --ros2 drive
  $ ls drive drive/launch drive/src drive/src/hosts drive/src/hosts/robot | grep -v -e '\.[ch]$'
  drive:
  CMakeLists.txt
  launch
  package.xml
  src
  
  drive/launch:
  drive.launch.py
  
  drive/src:
  core
  drivers
  elementary
  frob
  hal
  hosts
  vision
  
  drive/src/hosts:
  camera
  common
  robot
  ros
  
  drive/src/hosts/robot:
  $ cat drive/package.xml
  <?xml version="1.0"?>
  <package format="3">
    <name>drive</name>
    <version>0.1.0</version>
    <description>The Frob program drive as a ROS 2 node</description>
    <maintainer email="you@example.com">you</maintainer>
    <!-- The license of the runtime; add the license of your program. -->
    <license>MIT</license>
  
    <buildtool_depend>ament_cmake</buildtool_depend>
    <depend>diagnostic_msgs</depend>
    <depend>geometry_msgs</depend>
    <depend>lifecycle_msgs</depend>
    <depend>nav_msgs</depend>
    <depend>rcl</depend>
    <depend>rcl_interfaces</depend>
    <depend>rcl_lifecycle</depend>
    <depend>rcl_yaml_param_parser</depend>
    <depend>rcutils</depend>
    <depend>rmw</depend>
    <depend>rosgraph_msgs</depend>
    <depend>rosidl_runtime_c</depend>
    <depend>rosidl_typesupport_introspection_c</depend>
    <depend>sensor_msgs</depend>
    <depend>std_msgs</depend>
    <depend>visualization_msgs</depend>
    <exec_depend>ros2launch</exec_depend>
  
    <export>
      <build_type>ament_cmake</build_type>
    </export>
  </package>

Building it does not require frobc. Here it is built without CMake, with the fake ROS 2.

  $ includes=$(for folder in prefix/include/*; do echo "-isystem $folder"; done)
  $ gcc -std=gnu11 -D_GNU_SOURCE -O1 -ffp-contract=off -fno-strict-aliasing -Wall -Werror -Idrive/src $includes $(find drive/src -name '*.c') -Lprefix/lib -lrcl -Wl,-rpath,$PWD/prefix/lib -ldl -lm -o node
  $ ./node --patience 1 --set late=1 --for 0.1 --ros-args -r __node:=from_package | head -1
  robot: node /from_package, odometry from /odom, velocity to /cmd_vel

Another export keeps the files that users edit.

  $ echo '# mine' >>drive/CMakeLists.txt; echo nonsense >drive/src/drive.c
  $ frobc export drive.frob --ros2 drive; tail -1 drive/CMakeLists.txt; grep -c nonsense drive/src/drive.c
  # mine
  0
  [1]

Names of packages are in lower case.

  $ cp drive.frob Drive_2.frob; frobc export Drive_2.frob --ros2 two; grep '<name>' two/package.xml; ls two/launch
    <name>drive_2</name>
  drive_2.launch.py

Mistakes:

  $ mkdir other; echo >other/file; frobc export drive.frob --ros2 other
  error: other already exists and is not an export of drive: move it away, or use another folder
  [2]
  $ frobc export drive.frob --ros2 three --robot scout
  error: --ros2 is for the robot `ros`, not for `scout`: remove --robot
  [2]
  $ frobc export drive.frob
  error: say what to export: use either --platformio DIR or --ros2 DIR
  [2]
  $ printf 'main :: SF Float Float\nmain = arr id\n' >function.frob; frobc export function.frob --ros2 three
  error: function is neither a robot program nor a node: use `reactimateRobot` for the robot `ros`, or `node 50[Hz]` if its input and output are records of topics
  [2]
