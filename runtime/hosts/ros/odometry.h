/* odometry.h -- converts a nav_msgs/msg/Odometry to the pose and speeds of a robot on a plane. */
#ifndef FROB_HOST_ROS_ODOMETRY_H
#define FROB_HOST_ROS_ODOMETRY_H

#include "messages.h"

#include <stddef.h>

struct ros_motion {
    double x_m, y_m, heading_rad; /* from -pi to pi, positive to the left */
    double speed_m_s, turning_rad_s;
};

/* Computes the yaw of a rotation, from -pi to pi. Returns false if `rotation` is not a quaternion
 * of length 1. */
bool ros_yaw_of(const double rotation[4], double *yaw_rad);

/* Converts the message. Returns NULL, or the reason why it is not usable. */
const char *ros_motion_of(const struct ros_odometry *odometry, struct ros_motion *motion);

#endif
