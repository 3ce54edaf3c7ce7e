/* Follow a wall; back up for 1 s after a bump; turn until the way is free: as
 * a careful person writes it in C. */
#ifndef BY_HAND_H
#define BY_HAND_H

#include "modes.h"

enum by_hand_mode { FOLLOW, BACK_UP, TURN };

struct by_hand {
    double side_before; /* one instant ago */
    double side_slope;  /* the last one, kept while time stands still */
    int64_t backing_ns; /* since the bump */
    uint8_t mode;       /* an enum by_hand_mode */
    bool started;
    bool condition_before; /* what ends the mode, one instant ago */
};

void by_hand_reset(struct by_hand *self);

/* dt in s, not looked at in the first step. */
void by_hand_step(struct by_hand *self, double dt, const struct modes_input *in,
                  struct modes_output *out);

#endif
