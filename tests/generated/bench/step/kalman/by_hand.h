/* A Kalman filter for odometry along a wall in C, as a careful programmer would write it. */
#ifndef BY_HAND_H
#define BY_HAND_H

#include "kalman.h"

struct by_hand {
    double offset, heading;                     /* the estimate */
    double var_offset, covariance, var_heading; /* and its covariances */
};

void by_hand_reset(struct by_hand *self);

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct kalman_input *in,
                  struct kalman_output *out);

/* Rounds dt, in s, to whole ns. */
void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct kalman_input *in,
                             struct kalman_output *out);

#endif
