/* A debounced button and its effects in C, as a careful programmer would write it. */
#ifndef BY_HAND_H
#define BY_HAND_H

#include "events.h"

struct by_hand {
    double at_press, sampled;
    int64_t time_ns;
    int64_t differs_since_ns;
    int64_t sampled_ns; /* the last multiple of the period */
    int32_t presses;
    bool started;
    bool button; /* debounced */
    bool differs;
    bool on;
};

void by_hand_reset(struct by_hand *self);

/* dt_ns and dt are the same time in ns and in s; 0 in the first step. */
void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct events_input *in,
                  struct events_output *out);

/* Rounds dt, in s, to whole ns. */
void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct events_input *in,
                             struct events_output *out);

#endif
