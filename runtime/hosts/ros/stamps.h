/* stamps.h -- decides whether messages are recent, even if their timestamps come from another
 * machine's clock.
 *
 * The clocks of two machines differ by an unknown amount. The message with the smallest difference
 * between arrival and timestamp had the shortest delay. A message with a larger difference was
 * delayed by the excess, so a message that waited in a queue is recognized as old.
 *
 * If timestamps go back or jump ahead, somebody has probably set the clock or restarted a
 * simulation. At first, such messages are rejected, because a single one may be due to an error.
 * When they have been arriving for one second, the new clock is accepted. */
#ifndef FROB_HOST_ROS_STAMPS_H
#define FROB_HOST_ROS_STAMPS_H

#include <stdbool.h>
#include <stdint.h>

struct stamps {
    bool started;
    int64_t first_ns;    /* arrival time of the first message */
    int64_t previous_ns; /* arrival time of the previous message that was not STAMPS_BACK */
    int64_t shortest_ns; /* smallest difference between arrival time and timestamp */
    int64_t newest_ns;   /* timestamp of the newest accepted message */
    bool doubted;        /* whether messages from another clock have arrived since the last accepted
                          * message */
    int64_t doubted_ns;  /* arrival time of the first such message */
    int64_t other_ns;    /* difference between arrival time and timestamp of the last such
                          * message */
};

enum stamps_verdict {
    STAMPS_GOOD,
    STAMPS_OLD,   /* the message was delayed by more than `patience_ns` */
    STAMPS_BACK,  /* its timestamp is earlier than that of the newest accepted message */
    STAMPS_AHEAD, /* its timestamp is ahead of the sender's clock by more than `patience_ns` */
    STAMPS_RESET  /* accepted: the new clock applies from now on */
};

/* Checks the next message. `by_ns` receives the delay of a good or old message, and otherwise the
 * size of the jump. A sender that does not set timestamps sends 0; in that case, every message is
 * good. */
enum stamps_verdict stamps_judge(struct stamps *stamps, int64_t stamp_ns, int64_t arrived_ns,
                                 int64_t patience_ns, int64_t *by_ns);

#endif
