/* inputs.h -- the topics that the node subscribes to, and their messages. */
#ifndef FROB_HOST_ROS_INPUTS_H
#define FROB_HOST_ROS_INPUTS_H

#include <frob/program.h>

#include <geometry_msgs/msg/point_stamped.h>
#include <nav_msgs/msg/odometry.h>
#include <rcl/rcl.h>
#include <rosgraph_msgs/msg/clock.h>
#include <sensor_msgs/msg/battery_state.h>
#include <sensor_msgs/msg/imu.h>
#include <sensor_msgs/msg/joy.h>
#include <sensor_msgs/msg/laser_scan.h>
#include <std_msgs/msg/bool.h>
#include <std_msgs/msg/empty.h>

#include "conversion.h"
#include "messages.h"
#include "parts.h"
#include "tf.h"
#include "topics.h"

/* One of the program's own topics. */
struct own_topic {
    uint32_t number; /* index in the program's table of topics */
    struct message_type type;
    struct mapping mapping;
    struct topic_parts parts;
    struct topic_span span;
    void *message;
    uint32_t count; /* number of messages received */
    bool told;      /* whether a message with an array of the wrong length was reported */
    /* Hashes of the unknown strings that have been reported. */
    uint32_t told_texts[8];
    size_t told_text_count;
};

struct input {
    enum ros_kind kind;
    uint32_t control; /* index in the program's console, for a sensor or control */
    struct own_topic own;
    char name[ROS_NAME];
    rcl_subscription_t subscription;
    struct topic topic;
    bool heard;
    union {
        nav_msgs__msg__Odometry odometry;
        sensor_msgs__msg__LaserScan scan;
        sensor_msgs__msg__Imu imu;
        rosgraph_msgs__msg__Clock clock;
        std_msgs__msg__Bool bumper;
        sensor_msgs__msg__BatteryState battery;
        geometry_msgs__msg__PointStamped click;
        sensor_msgs__msg__Joy joy;
        std_msgs__msg__Empty press;
        struct tf_message transforms;
    } message;
};

struct inputs {
    struct input *each;
    size_t count;
    struct ros_scan scan;            /* the message to send next */
    struct ros_topic_message *value; /* the next message on one of the program's own topics */
    char *values;                    /* a struct of the program's input, for conversions */
    struct tf tf;
    int64_t clock_ns; /* newest time of /clock; accessed atomically */
};

/* Sets up the inputs of a program. `inputs` must already be zero: clearing it here would touch all
 * its pages, most of which are never used. Returns false on failure; then `why` contains the
 * reason. */
bool inputs_of(struct inputs *inputs, const struct frob_program *program, bool use_sim_time,
               bool has_joystick, char *why, size_t room);

/* Returns whether the program needs a message on this topic before it can run. */
bool inputs_is_needed(const struct input *input);

/* Returns whether the input is a sensor or bumper that the program uses. */
bool inputs_is_sensor(const struct input *input);

/* Returns whether the input must not lose any message. If so, it cannot receive from a publisher
 * with best-effort delivery. */
bool inputs_is_reliable(const struct input *input);

/* Subscribes to all topics. Returns NULL, or the name of the topic that failed. */
const char *inputs_subscribe(struct inputs *inputs, const rcl_node_t *node);

/* Forwards all messages that have arrived to the supervisor. If the supervisor does not keep up,
 * drops messages, because they would be outdated when it reads them. */
void inputs_take(struct inputs *inputs, struct input *input, int socket);

#endif
