/* tf.h -- reads the transforms of /tf_static and /tf.
 *
 * A minimal installation of ROS 2 does not contain the package tf2_msgs. Therefore the node does
 * not use its headers, and opens the message's type support library only if it is installed. */
#ifndef FROB_HOST_ROS_TF_H
#define FROB_HOST_ROS_TF_H

#include <geometry_msgs/msg/transform_stamped.h>
#include <nav_msgs/msg/odometry.h>
#include <rcl/rcl.h>

#include "frames.h"
#include "messages.h"

/* A tf2_msgs/msg/TFMessage. */
struct tf_message {
    geometry_msgs__msg__TransformStamped__Sequence transforms;
};

struct tf {
    bool is_read;                               /* whether the node subscribes to /tf_static and
                                                 * /tf */
    char odometry[ROS_FRAME], robot[ROS_FRAME]; /* the names of the robot's frames */
    struct frames frames;
    bool told; /* whether an invalid transform was reported */
};

/* Returns NULL if tf2_msgs is not installed. */
const rosidl_message_type_support_t *tf_type(void);

/* Sets the default frame names. `tf` must be zeroed. */
void tf_start(struct tf *tf);

/* Copies the names of the robot's frames from an odometry message. */
void tf_name(struct tf *tf, const nav_msgs__msg__Odometry *odometry);

/* Stores the transforms of a message. */
void tf_take(struct tf *tf, const struct tf_message *message, const char *topic, bool is_fixed,
             int64_t now_ns);

/* Finds the pose of a frame relative to the robot's frame, or to the odometry frame. If `name` is
 * empty, finds the pose of that reference frame itself. `pose` is valid only if the result is
 * ROS_FOUND. */
struct ros_placing tf_place(const struct tf *tf, bool in_odometry, const char *name, int64_t now_ns,
                            struct frames_pose *pose);

#endif
