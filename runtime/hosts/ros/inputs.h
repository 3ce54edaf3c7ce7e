/* inputs.h -- the topics that the node subscribes to, and their messages. */
#ifndef FROB_HOST_ROS_INPUTS_H
#define FROB_HOST_ROS_INPUTS_H

#include <frob/program.h>

#include <nav_msgs/msg/odometry.h>
#include <rcl/rcl.h>
#include <sensor_msgs/msg/imu.h>
#include <sensor_msgs/msg/laser_scan.h>

#include "messages.h"
#include "parts.h"

/* The odometry, and as many sensors as a program may use. */
enum { INPUTS_MOST = 1 + ROS_SENSORS_MOST };

struct input {
    enum ros_kind kind;
    uint32_t control; /* of the program's console, for a sensor */
    char name[ROS_NAME];
    rcl_subscription_t subscription;
    struct topic topic;
    bool heard;
    union {
        nav_msgs__msg__Odometry odometry;
        sensor_msgs__msg__LaserScan scan;
        sensor_msgs__msg__Imu imu;
    } message;
};

struct inputs {
    struct input each[INPUTS_MOST];
    size_t count;
    struct ros_scan scan; /* the one that is sent */
};

/* Determines the inputs of a program. Returns false if it has too many sensors. */
bool inputs_of(struct inputs *inputs, const struct frob_program *program);

/* Subscribes to all topics. Returns NULL, or the name of the topic that failed. */
const char *inputs_subscribe(struct inputs *inputs, const rcl_node_t *node);

/* Sends all messages that have arrived to the supervisor. A message is dropped if the supervisor does
 * not keep up: it would be old when the supervisor reads it. */
void inputs_take(struct inputs *inputs, struct input *input, int socket);

#endif
