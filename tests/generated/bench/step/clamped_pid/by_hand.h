/* A PID controller with conditional integration, in C, as a careful programmer would write it. */
#ifndef BY_HAND_H
#define BY_HAND_H

#include "clamped_pid.h"

struct by_hand {
    double error_before;
    double sum;
    double slope; /* the last slope, kept while dt is 0 */
    bool started; /* only for by_hand_step_in_seconds */
};

void by_hand_reset(struct by_hand *self);

/* dt_ns and dt are the same time in ns and in s; 0 in the first step. */
void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt,
                  const struct clamped_pid_input *in, struct clamped_pid_output *out);

/* Rounds dt, in s, to whole ns; ignores the first dt. */
void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct clamped_pid_input *in,
                             struct clamped_pid_output *out);

#endif
