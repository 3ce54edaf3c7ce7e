#!/bin/sh
# usage: build.sh SOURCES PREFIX : installs the fake ROS 2 in PREFIX, for AMENT_PREFIX_PATH.
set -e
sources=$1 prefix=$2
mkdir -p "$prefix/lib" "$prefix/share/ament_index/resource_index/packages" "$prefix/share/rcl"
echo '<package><version>9.2.8</version></package>' >"$prefix/share/rcl/package.xml"
header() { # header PACKAGE PATH
    mkdir -p "$(dirname "$prefix/include/$1/$2")"
    echo '#include <fake_ros.h>' >"$prefix/include/$1/$2"
}
header rcl rcl/rcl.h
header rcl rcl/error_handling.h
header rcl rcl/graph.h
header rmw rmw/qos_profiles.h
header rosidl_runtime_c rosidl_runtime_c/string_functions.h
header geometry_msgs geometry_msgs/msg/twist.h
header geometry_msgs geometry_msgs/msg/twist_stamped.h
header nav_msgs nav_msgs/msg/odometry.h
header sensor_msgs sensor_msgs/msg/laser_scan.h
header sensor_msgs sensor_msgs/msg/imu.h
cp "$sources/fake_ros.h" "$prefix/include/rcl/"
gcc -shared -fPIC -O1 -o "$prefix/lib/librcl.so" "$sources/fake_ros.c" -lm
for library in rmw rcutils rosidl_runtime_c geometry_msgs__rosidl_typesupport_c \
    geometry_msgs__rosidl_generator_c nav_msgs__rosidl_typesupport_c nav_msgs__rosidl_generator_c \
    sensor_msgs__rosidl_typesupport_c sensor_msgs__rosidl_generator_c; do
    echo | gcc -shared -fPIC -x c - -o "$prefix/lib/lib$library.so"
done
for package in rcl rmw rcutils rosidl_runtime_c geometry_msgs nav_msgs sensor_msgs; do
    : >"$prefix/share/ament_index/resource_index/packages/$package"
done
