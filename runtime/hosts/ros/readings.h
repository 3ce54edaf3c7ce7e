/* readings.h -- passes the readings of the robot's lidars, inertial measurement units and bumpers
 * from the node's messages to the program's input. */
#ifndef FROB_HOST_ROS_READINGS_H
#define FROB_HOST_ROS_READINGS_H

#include <frob/program.h>

#include <stddef.h>
#include <stdint.h>

#include "messages.h"

struct ros_device;

void ros_take_scan(struct ros_device *device, const struct ros_scan *message);
void ros_take_imu(struct ros_device *device, const struct ros_imu *message);
void ros_take_bumper(struct ros_device *device, const struct ros_bumper *message);

/* For this instant, sets the controls that represent sensors. */
void ros_give_readings(struct ros_device *device, const struct frob_program *program, void *input,
                       int64_t now_ns);

/* Explains in `why` that no transform is known for the frame of a message. `effect`: the
 * consequence. `how`: how the user can do without the transform. */
void ros_explain_frame(const struct ros_placing *placing, const char *effect, const char *how,
                       char *why, size_t room);

/* Returns the time at which a lidar's position became unknown and its readings therefore stopped.
 * Returns `sensed_ns` if that is earlier, or if all positions are known. */
int64_t ros_placed_ns(const struct ros_device *device, int64_t sensed_ns);

#endif
