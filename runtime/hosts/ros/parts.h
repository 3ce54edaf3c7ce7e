/* parts.h -- declarations shared by the files of the node's process. */
#ifndef FROB_HOST_ROS_PARTS_H
#define FROB_HOST_ROS_PARTS_H

#include <rcl/rcl.h>

#include <stdbool.h>
#include <stdint.h>

/* A topic, and the type of its messages in this program. */
struct topic {
    const char *name; /* after remapping */
    const char *type; /* "nav_msgs/msg/Odometry" */
    bool told;        /* whether a node that uses a different type was reported */
    bool told_silence;
    bool told_reliability; /* whether a node whose reliability is incompatible was reported */
    bool told_durability;  /* whether a node whose durability is incompatible was reported */
    const char *kept; /* the messages that a late subscriber does not receive: "old velocities" */
    const char *cure; /* advice if a subscriber expects TwistStamped; "" if there is none */
};

struct inputs;

/* State for the reports about other nodes. */
struct graph {
    struct inputs *inputs;
    struct topic *published;
    size_t published_count;
    int64_t started_ns, checked_ns;
    bool told_name;
};

/* Returns the time of the monotonic clock. */
int64_t node_now_ns(void);

/* Returns the time for timestamps: the time of /clock if use_sim_time is set, otherwise this
 * machine's time. */
int64_t node_stamp_ns(void);

/* Checks the other nodes once a second. Reports topics without a publisher, messages of a
 * different type, and a second node with the same name. Each problem is reported once. */
void graph_look(struct graph *graph, const rcl_node_t *node);

#endif
