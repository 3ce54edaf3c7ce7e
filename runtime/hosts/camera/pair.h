/* pair.h -- two cameras, `left` and `right`, whose frames belong together in pairs.
 *
 * Each takes its frames when it likes. Two of them are a pair if each is the nearest to the other
 * in time; so they are if they are at most half a period of the faster camera apart. A tenth more
 * is allowed, for cameras that are not quite regular. No I/O. */
#ifndef FROB_HOST_CAMERA_PAIR_H
#define FROB_HOST_CAMERA_PAIR_H

#include "buffers.h"

/* The time between two frames of a camera, by their times and numbers. */
struct rhythm {
    double period_ns;
    int64_t captured_ns; /* of the newest frame that was looked at, and its number */
    uint32_t number;
    bool has_any;
};

struct pair {
    struct rhythm rhythms[2];
    int64_t within_ns;  /* what the user allows; -1: as much as is right */
    uint32_t count;     /* of pairs that were taken */
    double apart_ns;    /* of those, summed */
    int64_t most_ns;    /* the greatest */
    int64_t nearest_ns; /* how far apart frames were since the last pair that were none; else
                         * INT64_MAX */
};

/* `period_s` of both until it is known; `within_s` may be NAN. */
void pair_init(struct pair *p, double period_s, double within_s);

/* How far apart a pair may be now. */
int64_t pair_most_ns(const struct pair *p);

/* The newest frames that are a pair, each as buffers_take gives it. False if there are none: those
 * that may yet become a pair stay where they are. */
bool pair_take(struct pair *p, struct buffers *const buffers[2], const struct captured *frames[2]);

#endif
