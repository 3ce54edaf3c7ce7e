/* pair.h -- combines the frames of two cameras, `left` and `right`, into pairs.
 *
 * The cameras are not synchronized. Two frames form a pair if each of them is the closest in time
 * to the other, which is the case if they are no further apart than half the period of the faster
 * camera. Another tenth of a period is allowed, because a camera may be slightly irregular. No
 * I/O. */
#ifndef FROB_HOST_CAMERA_PAIR_H
#define FROB_HOST_CAMERA_PAIR_H

#include "buffers.h"

/* The period between a camera's frames, estimated from their times and numbers. */
struct rhythm {
    double period_ns;
    int64_t captured_ns; /* time of the newest frame that has arrived; `number` is its number */
    uint32_t number;
    bool has_any;
};

struct pair {
    struct rhythm rhythms[2];
    int64_t within_ns; /* limit that the user has set; -1 if there is none */
    uint32_t count;    /* number of pairs that were taken */
    double apart_ns;   /* sum of the time differences within these pairs */
    int64_t most_ns;   /* maximum of these differences */
    /* The smallest time difference, since the last pair, between two frames that were too far
     * apart; INT64_MAX if there were none. */
    int64_t nearest_ns;
};

/* Initializes the periods with `period_s`; `within_s` may be NAN. */
void pair_init(struct pair *p, double period_s, double within_s);

/* Returns the current maximum time difference within a pair. */
int64_t pair_most_ns(const struct pair *p);

/* Takes the newest frames that form a pair, each as buffers_take does. Returns false if there is no
 * pair. Does not take frames that may still become part of a pair. */
bool pair_take(struct pair *p, struct buffers *const buffers[2], const struct captured *frames[2]);

#endif
