/* device.h -- the driver of the robot `ros`, whose line leads to the node (node.h).
 *
 * Like every driver, it decides nothing about safety: core/robot.h stops the robot if the newest
 * odometry is too old. Messages that are late, or whose numbers are not usable, do not count as
 * readings. The first of each kind is reported. */
#ifndef FROB_HOST_ROS_DEVICE_H
#define FROB_HOST_ROS_DEVICE_H

#include "drivers/driver.h"
#include "messages.h"
#include "odometry.h"
#include "stamps.h"

/* The driver's settings, in the order of its table. */
enum ros_setting { ROS_FASTEST, ROS_FASTEST_TURN, ROS_LATE, ROS_STAMPED, ROS_SETTINGS };

enum { ROS_VERDICTS = STAMPS_RESET + 1 };

struct ros_device {
    const double *settings;
    struct frob_serial serial;
    struct frob_clock clock;
    union {
        struct ros_head head;
        struct ros_started started;
        struct ros_refused refused;
        struct ros_odometry odometry;
        uint8_t bytes[ROS_MESSAGE_MOST];
    } message;   /* the one that is being received, and */
    size_t have; /* its number of bytes so far */
    struct ros_started started;
    struct stamps stamps;
    struct ros_motion motion;
    int64_t sensed_ns;   /* when the newest good odometry left its sender; INT64_MIN: never */
    int64_t received_ns; /* when the last odometry arrived, good or not; INT64_MIN: never */
    bool told_silence;
    bool commanded; /* a velocity was commanded; it is repeated */
    bool drove;     /* one was commanded since the first session */
    struct ros_velocity velocity;
    int64_t sent_ns;
    bool told[ROS_VERDICTS]; /* stamps that were reported */
    const char *told_bad;    /* reason for unusable numbers that was reported last */
};

extern const struct frob_driver frob_ros_driver;

#endif
