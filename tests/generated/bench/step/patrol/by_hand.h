/* Follow a wall; after a bump, back up for 1 s and wait for 0.5 s; turn until the way is clear. A
 * state machine in C, as a careful programmer would write it. */
#ifndef BY_HAND_H
#define BY_HAND_H

#include "patrol.h"

enum by_hand_state { FOLLOW, BACK_UP, WAIT, TURN };

struct by_hand {
    int64_t since_ns; /* start of the state, if it needs it */
    uint8_t state;    /* an enum by_hand_state */
    bool started;
    bool condition_before; /* the condition that ends the state, at the previous instant */
};

void by_hand_reset(struct by_hand *self);

/* dt_ns and dt are the same time in ns and in s; 0 in the first step. */
void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct patrol_input *in,
                  struct patrol_output *out);

/* Rounds dt, in s, to whole ns. */
void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct patrol_input *in,
                             struct patrol_output *out);

#endif
