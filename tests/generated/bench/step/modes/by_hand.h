/* Follow a wall; back up for 1 s after a bump; turn until the way is clear. Written in C as a
 * careful programmer would. */
#ifndef BY_HAND_H
#define BY_HAND_H

#include "modes.h"

enum by_hand_mode { FOLLOW, BACK_UP, TURN };

struct by_hand {
    double side_before; /* at the previous instant */
    double side_slope;  /* the last slope, kept while dt is 0 */
    int64_t backing_ns; /* time since the bump */
    uint8_t mode;       /* an enum by_hand_mode */
    bool started;
    bool condition_before; /* the condition that ends the mode, at the previous instant */
};

void by_hand_reset(struct by_hand *self);

/* dt_ns and dt are the same time in ns and in s; 0 in the first step. */
void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct modes_input *in,
                  struct modes_output *out);

/* Rounds dt, in s, to whole ns. */
void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct modes_input *in,
                             struct modes_output *out);

#endif
