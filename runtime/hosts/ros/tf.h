/* tf.h -- reads the transforms of /tf_static and /tf.
 *
 * A minimal installation of ROS 2 does not contain the package tf2_msgs, so the node does not need
 * its headers: it opens the library of the message's type support, if there is one. */
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
    bool is_read;                               /* the node subscribes to /tf_static and /tf */
    char odometry[ROS_FRAME], robot[ROS_FRAME]; /* the names of the robot's frames */
    struct frames frames;
    bool told; /* a bad transform was reported */
};

/* Returns NULL if tf2_msgs is not installed. */
const rosidl_message_type_support_t *tf_type(void);

/* `tf` is zero. */
void tf_start(struct tf *tf);

/* Takes the names of the robot's frames from its odometry. */
void tf_name(struct tf *tf, const nav_msgs__msg__Odometry *odometry);

/* Takes the transforms of a message. */
void tf_take(struct tf *tf, const struct tf_message *message, const char *topic, bool is_fixed,
             int64_t now_ns);

/* Finds a frame in the robot's frame, or in that of its odometry. An empty name is that frame
 * itself. `pose` is only valid for ROS_FOUND. */
struct ros_placing tf_place(const struct tf *tf, bool in_odometry, const char *name, int64_t now_ns,
                            struct frames_pose *pose);

#endif
