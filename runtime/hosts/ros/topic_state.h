/* topic_state.h -- the state of one topic of the robot `ros`. */
#ifndef FROB_HOST_ROS_TOPIC_STATE_H
#define FROB_HOST_ROS_TOPIC_STATE_H

#include <stdbool.h>
#include <stdint.h>

#include "messages.h"
#include "stamps.h"

enum { ROS_VERDICTS = STAMPS_RESET + 1 };

/* The state of one topic: whether messages arrive, and which faults were reported. */
struct ros_topic {
    char name[ROS_NAME]; /* name of the topic; "" until it is known */
    struct stamps stamps;
    int64_t received_ns; /* arrival time of the last message, valid or not; INT64_MIN if there was
                          * none */
    bool told_silence;
    bool told[ROS_VERDICTS]; /* timestamp faults that were reported */
    const char *told_bad;    /* the last reported reason for rejecting a message */
};

#endif
