/* Nested modes for duty, patrol and caution in C, as a careful programmer would write them. */
#ifndef BY_HAND_H
#define BY_HAND_H

#include "nested.h"

struct by_hand {
    double speed;     /* while accelerating */
    int64_t since_ns; /* start of the drive or turn */
    bool started;
    bool working;
    bool turning;
    bool slow;
    bool duty_before; /* the conditions that may end a mode, at the previous instant */
    bool close_before;
    bool near_before;
    bool free_before;
};

void by_hand_reset(struct by_hand *self);

/* dt_ns and dt are the same time in ns and in s; 0 in the first step. */
void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct nested_input *in,
                  struct nested_output *out);

/* Rounds dt, in s, to whole ns. */
void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct nested_input *in,
                             struct nested_output *out);

#endif
