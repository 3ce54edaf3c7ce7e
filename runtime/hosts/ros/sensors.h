/* sensors.h -- the lidars and inertial measurement units of the robot `ros`: their newest messages,
 * and the readings that a program receives from them at an instant. */
#ifndef FROB_HOST_ROS_SENSORS_H
#define FROB_HOST_ROS_SENSORS_H

#include <frob/imu.h>
#include <frob/lidar.h>
#include <frob/program.h>

#include <stdbool.h>
#include <stddef.h>

#include "messages.h"

/* Converts a scan; `room` receives its distances, and must have space for all of them. Returns
 * NULL, or the reason why the scan is invalid. */
const char *ros_scan_of(const struct ros_scan *message, const struct ros_seat *seat, double *room,
                        struct frob_scan *scan);

/* Measurements since the program last read the inertial measurement unit. */
struct ros_measurements {
    double rate_radps[3], acceleration_mps2[3]; /* sums */
    double heading_rad; /* heading in the last measurement; NaN if that had none */
    uint32_t count;     /* number of measurements in the sums */
    uint32_t number;    /* number of measurements since the start */
};

/* Returns NULL, or the reason why the message is invalid. */
const char *ros_imu_check(const struct ros_imu *message);

/* Rotates a valid message from the sensor's frame to the robot's frame. */
void ros_imu_turn(struct ros_imu *message);

/* Adds a valid measurement. */
void ros_imu_add(struct ros_measurements *sums, const struct ros_imu *message);

/* Returns the means, as a reading at this time. There must be at least one measurement. */
struct frob_imu ros_imu_mean(const struct ros_measurements *sums, int64_t taken_ns);

/* Resets the sums. */
void ros_imu_restart(struct ros_measurements *sums);

/* Writes a sensor's topic to `name`, without the namespace. For a bumper, that is a name such as
 * `bumper_left`; for the lidar `lidar`, it is `scan`; for other sensors, it is the name in the
 * program. Returns false if the control is not a sensor. */
bool ros_topic_of(const struct frob_control *control, char *name, size_t room);

/* Returns the first control that uses the same sensor as control `i`. */
size_t ros_first_user(const struct frob_program *program, size_t i);

#endif
