/* messages.h -- the messages between the supervisor and the node, which is a process of its own
 * (node.h). Both processes run the same executable, so a message is a struct.
 *
 * Each message begins with its size and kind. The socket between the processes transfers a message
 * whole or not at all. */
#ifndef FROB_HOST_ROS_MESSAGES_H
#define FROB_HOST_ROS_MESSAGES_H

#include <stdbool.h>
#include <stdint.h>

enum ros_kind {
    /* From the node. */
    ROS_STARTED = 1, /* it has joined the ROS 2 system; the rest is a struct ros_started */
    ROS_REFUSED,     /* it could not; the rest is a struct ros_refused */
    ROS_ODOMETRY,
    /* To the node. */
    ROS_VELOCITY
};

struct ros_head {
    uint32_t size; /* of the whole message */
    uint32_t kind;
};

enum { ROS_NAME = 256, ROS_REASON = 1024 };

struct ros_started {
    struct ros_head head;
    char node[ROS_NAME];     /* with its namespace: "/wall_follow" */
    char odometry[ROS_NAME]; /* the names of the topics, after remapping */
    char velocity[ROS_NAME];
};

struct ros_refused {
    struct ros_head head;
    char reason[ROS_REASON];
};

/* The numbers of a nav_msgs/msg/Odometry, unchecked. */
struct ros_odometry {
    struct ros_head head;
    int64_t stamp_ns;   /* of the header, on the sender's clock */
    int64_t arrived_ns; /* when the node received it, on this machine's monotonic clock */
    double x_m, y_m;
    double rotation[4]; /* quaternion: x, y, z, w */
    double speed_m_s, turning_rad_s;
};

/* Publish this velocity. */
struct ros_velocity {
    struct ros_head head;
    double speed_m_s, turn_rad_s;
};

/* Size of the largest message, in bytes. */
enum { ROS_MESSAGE_MOST = ROS_REASON + 64 };

#endif
