/* stamps.h -- decides whether messages are recent, although their timestamps come from another
 * machine's clock.
 *
 * The clocks of two machines differ by an unknown amount. The message with the smallest difference
 * between arrival and timestamp had the shortest delay. A message with a larger difference was
 * delayed by the excess, so a message that waited in a queue is recognized as old.
 *
 * If timestamps go back or jump ahead, somebody set the clock or restarted a simulation. Such
 * messages are rejected at first, because a single one may be an error. When they have arrived for
 * a second, the new clock is accepted. */
#ifndef FROB_HOST_ROS_STAMPS_H
#define FROB_HOST_ROS_STAMPS_H

#include <stdbool.h>
#include <stdint.h>

struct stamps {
    bool started;
    int64_t first_ns;    /* arrival of the first message */
    int64_t previous_ns; /* arrival of the previous accepted message */
    int64_t shortest_ns; /* smallest difference between arrival and stamp */
    int64_t newest_ns;   /* stamp of the newest accepted message */
    bool doubted;        /* messages with another clock have arrived, described below */
    int64_t doubted_ns;  /* arrival of the first one */
    int64_t other_ns;    /* difference between arrival and stamp of the last one */
};

enum stamps_verdict {
    STAMPS_GOOD,
    STAMPS_OLD,   /* delayed by more than the patience */
    STAMPS_BACK,  /* its timestamp is before an earlier message's */
    STAMPS_AHEAD, /* its timestamp is ahead of the sender's clock by more than the patience */
    STAMPS_RESET  /* accepted: from now on, the new clock applies */
};

/* Checks the next message. `by_ns` receives the delay of a good or old message, and otherwise the
 * size of the jump. A sender that does not fill in stamps sends 0; then every message is good. */
enum stamps_verdict stamps_judge(struct stamps *stamps, int64_t stamp_ns, int64_t arrived_ns,
                                 int64_t patience_ns, int64_t *by_ns);

#endif
