/* transforms.h -- the robot's frames: `odom` to `base_link` on /tf, and `base_link` to the frames
 * of its sensors on /tf_static.
 *
 * A minimal installation of ROS 2 does not contain the package tf2_msgs. Therefore the node does
 * not use its headers. When it starts, it opens the message's type support library if it is
 * installed. */
#ifndef FROB_HOST_ROS_ROBOT_TRANSFORMS_H
#define FROB_HOST_ROS_ROBOT_TRANSFORMS_H

#include <geometry_msgs/msg/transform_stamped.h>
#include <nav_msgs/msg/odometry.h>
#include <rcl/rcl.h>

#include <stdbool.h>
#include <stddef.h>

/* A sensor's frame, whose axes are parallel to those of `base_link`. */
struct seat {
    char frame[256 + 8];
    double x_m, y_m; /* position relative to the robot's centre: ahead, and to the left */
};

/* A tf2_msgs/msg/TFMessage. */
struct transforms_message {
    geometry_msgs__msg__TransformStamped__Sequence transforms;
};

struct transforms {
    bool has_type; /* whether the type support was found; otherwise nothing is published */
    rcl_publisher_t moving, fixed;
    struct transforms_message odometry, seats;
};

/* Publishes the sensors' frames, which never change, if the type support is installed. Returns
 * false if rcl reports an error. */
bool transforms_start(struct transforms *t, const rcl_node_t *node, const struct seat *seats,
                      size_t count, builtin_interfaces__msg__Time now);

/* Publishes the robot's pose. */
void transforms_publish(struct transforms *t, const nav_msgs__msg__Odometry *odometry);

/* Returns false if rcl reports an error. */
bool transforms_end(struct transforms *t, rcl_node_t *node);

#endif
