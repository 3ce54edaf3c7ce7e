/* frames.h -- the frames of reference of a robot in ROS 2: a tree of transforms, which nodes
 * publish on /tf_static and /tf.
 *
 * Transforms from /tf_static are always valid. The newest transform of a frame from /tf is valid
 * for a few seconds, and is used without interpolation. */
#ifndef FROB_HOST_ROS_FRAMES_H
#define FROB_HOST_ROS_FRAMES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "messages.h"

enum { FRAMES_MOST = 256 };

/* The pose of a frame in another frame. */
struct frames_pose {
    double at_m[3];
    double rotation[4]; /* quaternion: x, y, z, w */
};

struct frame {
    char name[ROS_FRAME], parent[ROS_FRAME];
    bool is_fixed;
    int64_t arrived_ns;
    struct frames_pose pose; /* in the frame `parent` */
};

struct frames {
    struct frame each[FRAMES_MOST];
    size_t count;
};

/* Sets the pose of a frame relative to its parent. Returns NULL, or the reason why the transform is
 * ignored. */
const char *frames_put(struct frames *frames, const char *parent, const char *name,
                       const struct frames_pose *pose, bool is_fixed, int64_t now_ns);

/* Finds the pose of a frame in the frame `in`. Returns false if the transforms do not connect
 * them. */
bool frames_find(const struct frames *frames, const char *in, const char *name, int64_t now_ns,
                 struct frames_pose *pose);

/* Rotates a vector by a quaternion. */
void frames_rotate(const double rotation[4], const double vector[3], double result[3]);

/* Computes the orientation of the robot from the orientation of a device and the device's mounting
 * on the robot. */
void frames_orientation(const double device[4], const double mounting[4], double result[4]);

/* Converts a point from the frame that has this pose to the frame in which the pose is given. */
void frames_point(const struct frames_pose *pose, const double point[3], double result[3]);

/* Returns the name without the leading slash that old nodes write. */
const char *frames_name(const char *name);

/* Converts the pose of a lidar in the robot's frame to a `ros_seat`. Returns false if the lidar is
 * tilted, so that its scans are not parallel to the floor. */
bool frames_seat(const struct frames_pose *pose, struct ros_seat *seat);

#endif
