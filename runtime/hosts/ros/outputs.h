/* outputs.h -- publishes the program's output: the velocity of a robot, or the program's own
 * topics. */
#ifndef FROB_HOST_ROS_OUTPUTS_H
#define FROB_HOST_ROS_OUTPUTS_H

#include <stdbool.h>
#include <stddef.h>

#include <frob/program.h>

#include <geometry_msgs/msg/twist.h>
#include <geometry_msgs/msg/twist_stamped.h>
#include <rcl/rcl.h>

#include "conversion.h"
#include "messages.h"
#include "parts.h"
#include "topics.h"

/* One of the program's own topics. */
struct own_output {
    const struct frob_topic *topic;
    struct message_type type;
    struct mapping mapping;
    struct topic_parts parts;
    void *message, *zero;
    bool told; /* whether a non-finite number in a command has been reported */
};

struct outputs {
    const struct frob_program *program;
    bool stamped; /* whether the velocity is a TwistStamped */
    rcl_publisher_t *publishers;
    struct topic *topics; /* with their names after remapping */
    size_t count;
    /* The velocity, for a program without its own topics. */
    geometry_msgs__msg__Twist twist;
    geometry_msgs__msg__TwistStamped stamped_twist;
    struct own_output *own;
};

/* Creates the publishers. On failure, returns false and explains why in `why`. If rcl
 * rejects a publisher, `why` ends with a colon, and the caller must append rcl's reason. */
bool outputs_start(struct outputs *outputs, const struct frob_program *program, bool stamped,
                   const rcl_node_t *node, char *why, size_t room);

/* Publishes a velocity. */
void outputs_drive(struct outputs *outputs, double speed_m_s, double turn_rad_s);

/* Publishes the program's own topics. `values`: the program's output. `rests`: whether to publish
 * zero on topics that are commands. */
void outputs_publish(struct outputs *outputs, const void *values, bool rests);

/* Publishes zero as the velocity, or on the program's topics that are commands. */
void outputs_rest(struct outputs *outputs);

/* Waits for subscribers to acknowledge the newest commands, at most `most_ns` for each topic. */
void outputs_wait(const struct outputs *outputs, int64_t most_ns);

/* Returns false if rcl reports an error. */
bool outputs_end(struct outputs *outputs, rcl_node_t *node);

#endif
