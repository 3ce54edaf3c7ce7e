/* An obstacle avoider with a ring of 16 sonars in C, as a careful programmer would write it. */
#ifndef BY_HAND_H
#define BY_HAND_H

#include "obstacles.h"

struct by_hand {
    double near[16]; /* the smoothed readings */
};

void by_hand_reset(struct by_hand *self);

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct obstacles_input *in,
                  struct obstacles_output *out);

/* Rounds dt, in s, to whole ns. */
void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct obstacles_input *in,
                             struct obstacles_output *out);

#endif
