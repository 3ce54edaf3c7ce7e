/* A debounced button and what it does, as a careful person writes it in C. */
#ifndef BY_HAND_H
#define BY_HAND_H

#include "events.h"

struct by_hand {
    double at_press, sampled;
    int64_t time_ns;
    int64_t differs_since_ns;
    int64_t sampled_ns; /* the multiple of the period reached last */
    int32_t presses;
    bool started;
    bool button; /* debounced */
    bool differs;
    bool on;
};

void by_hand_reset(struct by_hand *self);

/* dt in s, not looked at in the first step. */
void by_hand_step(struct by_hand *self, double dt, const struct events_input *in,
                  struct events_output *out);

#endif
