/* pair.h -- combines the frames of two cameras, `left` and `right`, into pairs.
 *
 * The cameras are not synchronized. Two frames are a pair if each is the closest in time to the
 * other; this is the case if they are at most half a period of the faster camera apart. A tenth of
 * a period more is allowed, for cameras that are slightly irregular. No I/O. */
#ifndef FROB_HOST_CAMERA_PAIR_H
#define FROB_HOST_CAMERA_PAIR_H

#include "buffers.h"

/* The period between a camera's frames, estimated from their times and numbers. */
struct rhythm {
    double period_ns;
    int64_t captured_ns; /* time of the newest frame seen; `number` is its number */
    uint32_t number;
    bool has_any;
};

struct pair {
    struct rhythm rhythms[2];
    int64_t within_ns; /* limit set by the user; -1: none */
    uint32_t count;    /* number of pairs taken */
    double apart_ns;   /* sum of the time differences within these pairs */
    int64_t most_ns;   /* maximum of these differences */
    /* The smallest time difference, since the last pair, of two frames that were too far apart;
     * INT64_MAX if there were none. */
    int64_t nearest_ns;
};

/* Initializes the periods with `period_s`; `within_s` may be NAN. */
void pair_init(struct pair *p, double period_s, double within_s);

/* Returns the current maximum time difference of a pair. */
int64_t pair_most_ns(const struct pair *p);

/* Takes the newest frames that form a pair, each as buffers_take does. Returns false if there is no
 * pair; frames that may still become part of a pair are not taken. */
bool pair_take(struct pair *p, struct buffers *const buffers[2], const struct captured *frames[2]);

#endif
