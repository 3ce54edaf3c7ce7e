/* stamps.h -- judges whether messages are recent, although their stamps come from another machine's
 * clock.
 *
 * The clocks of two machines differ by an unknown amount. The message with the smallest difference
 * between arrival and stamp had the shortest way. Any other message was delayed by the amount by
 * which its difference is larger, so a message that waited in a queue is recognized as old.
 *
 * Stamps that go back or jump ahead mean that somebody set the clock, or that a simulation was
 * restarted. Such messages are refused at first, because a single one may be a mistake. When they
 * have arrived for a second, the new clock counts. */
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
    bool doubted;        /* messages of another clock have arrived: the following describe them */
    int64_t doubted_ns;  /* arrival of the first one */
    int64_t other_ns;    /* difference between arrival and stamp of the last one */
};

enum stamps_verdict {
    STAMPS_GOOD,
    STAMPS_OLD,   /* delayed by more than the patience */
    STAMPS_BACK,  /* its stamp is before that of an earlier message */
    STAMPS_AHEAD, /* its stamp is more than the patience ahead of the sender's clock */
    STAMPS_RESET  /* good: from now on, the clock that was set counts */
};

/* Judges the next message. `by_ns` receives the delay of a good or old message, and otherwise the
 * size of the jump. A sender that does not fill in stamps sends 0; then every message is good. */
enum stamps_verdict stamps_judge(struct stamps *stamps, int64_t stamp_ns, int64_t arrived_ns,
                                 int64_t patience_ns, int64_t *by_ns);

#endif
