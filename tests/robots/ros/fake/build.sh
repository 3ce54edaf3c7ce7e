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
header rcl_lifecycle rcl_lifecycle/rcl_lifecycle.h
for message in state transition transition_description transition_event; do
    header lifecycle_msgs lifecycle_msgs/msg/$message.h
done
for service in change_state get_state get_available_states get_available_transitions; do
    header lifecycle_msgs lifecycle_msgs/srv/$service.h
done
header rcl_yaml_param_parser rcl_yaml_param_parser/parser.h
header rcutils rcutils/allocator.h
header rcutils rcutils/error_handling.h
header rmw rmw/qos_profiles.h
header rosidl_runtime_c rosidl_runtime_c/string_functions.h
header rosidl_typesupport_introspection_c rosidl_typesupport_introspection_c/message_introspection.h
header rosidl_typesupport_introspection_c rosidl_typesupport_introspection_c/field_types.h
header geometry_msgs geometry_msgs/msg/twist.h
header geometry_msgs geometry_msgs/msg/twist_stamped.h
header geometry_msgs geometry_msgs/msg/point_stamped.h
header geometry_msgs geometry_msgs/msg/transform_stamped.h
for message in floating_point_range integer_range parameter parameter_descriptor parameter_event \
    parameter_value set_parameters_result; do
    header rcl_interfaces rcl_interfaces/msg/$message.h
done
for service in set_parameters set_parameters_atomically get_parameters get_parameter_types \
    describe_parameters list_parameters; do
    header rcl_interfaces rcl_interfaces/srv/$service.h
done
header rosgraph_msgs rosgraph_msgs/msg/clock.h
header rosidl_runtime_c rosidl_runtime_c/primitives_sequence_functions.h
header diagnostic_msgs diagnostic_msgs/msg/diagnostic_array.h
header diagnostic_msgs diagnostic_msgs/msg/diagnostic_status.h
header geometry_msgs geometry_msgs/msg/point.h
header visualization_msgs visualization_msgs/msg/marker.h
header visualization_msgs visualization_msgs/msg/marker_array.h
header std_msgs std_msgs/msg/string.h
header std_msgs std_msgs/msg/header.h
header std_msgs std_msgs/msg/bool.h
header std_msgs std_msgs/msg/empty.h
header sensor_msgs sensor_msgs/msg/joy.h
header sensor_msgs sensor_msgs/msg/battery_state.h
header sensor_msgs sensor_msgs/msg/image.h
header sensor_msgs sensor_msgs/msg/compressed_image.h
header nav_msgs nav_msgs/msg/odometry.h
header sensor_msgs sensor_msgs/msg/laser_scan.h
header sensor_msgs sensor_msgs/msg/imu.h
cp "$sources/fake_ros.h" "$sources/fake_lifecycle.h" "$prefix/include/rcl/"
gcc -shared -fPIC -O1 -o "$prefix/lib/librcl.so" "$sources/fake_ros.c" "$sources/fake_lifecycle.c" -lm
for library in rcl_yaml_param_parser rmw rcutils rosidl_runtime_c geometry_msgs__rosidl_typesupport_c \
    geometry_msgs__rosidl_generator_c nav_msgs__rosidl_typesupport_c nav_msgs__rosidl_generator_c \
    sensor_msgs__rosidl_typesupport_c sensor_msgs__rosidl_generator_c \
    rosgraph_msgs__rosidl_typesupport_c rosgraph_msgs__rosidl_generator_c \
    rcl_interfaces__rosidl_typesupport_c rcl_interfaces__rosidl_generator_c \
    std_msgs__rosidl_typesupport_c std_msgs__rosidl_generator_c; do
    echo | gcc -shared -fPIC -x c - -o "$prefix/lib/lib$library.so"
done
# The libraries that the host loads at run time. All functions are in librcl.so, but those for types
# are in libraries of their packages. A type is a word PACKAGE/KIND/NAME.
late() { # late LIBRARY [TYPE]...
    library=$1
    shift
    echo '#include <fake_ros.h>' >"$prefix/late.c"
    for type in "$@"; do
        package=${type%%/*} name=${type##*/} kind=message fake=${type%%/*}_${type##*/}
        case $type in */srv/*) kind=service fake=${package}_srv_$name ;; esac
        folder=${type%/*} folder=${folder#*/}
        handle=rosidl_typesupport_c__get_${kind}_type_support_handle__${package}__${folder}__$name
        printf '%s\n' "const void *$handle(void);" \
            "const void *$handle(void) { return &fake_$fake; }" >>"$prefix/late.c"
    done
    gcc -shared -fPIC -I"$sources" -o "$prefix/lib/lib$library.so" "$prefix/late.c" \
        -Wl,--no-as-needed -L"$prefix/lib" -lrcl
}
late std_msgs__rosidl_typesupport_c std_msgs/msg/Bool std_msgs/msg/String
late geometry_msgs__rosidl_typesupport_c geometry_msgs/msg/Twist
late tf2_msgs__rosidl_typesupport_c tf2_msgs/msg/TFMessage
late diagnostic_msgs__rosidl_typesupport_c diagnostic_msgs/msg/DiagnosticArray
late visualization_msgs__rosidl_typesupport_c visualization_msgs/msg/MarkerArray
late lifecycle_msgs__rosidl_typesupport_c lifecycle_msgs/msg/TransitionEvent \
    lifecycle_msgs/srv/ChangeState lifecycle_msgs/srv/GetState \
    lifecycle_msgs/srv/GetAvailableStates lifecycle_msgs/srv/GetAvailableTransitions
for package in diagnostic_msgs visualization_msgs lifecycle_msgs; do
    late ${package}__rosidl_generator_c
done
late rcl_lifecycle
for package in rcl rosidl_typesupport_introspection_c rcl_lifecycle lifecycle_msgs rcl_yaml_param_parser rmw rcutils rosidl_runtime_c geometry_msgs nav_msgs sensor_msgs rosgraph_msgs \
    rcl_interfaces std_msgs diagnostic_msgs visualization_msgs; do
    : >"$prefix/share/ament_index/resource_index/packages/$package"
done
