/* The wall follower of the Frob paper (section 3) in C, as a careful programmer would write it. */
#ifndef BY_HAND_H
#define BY_HAND_H

#include "wall_follow.h"

struct by_hand {
    double sin_theta_max;
    double s_before; /* the side distance at the previous instant */
    double s_dot;    /* the last slope, kept while dt is 0 */
    bool started;    /* only for by_hand_step_in_seconds */
};

void by_hand_reset(struct by_hand *self);

/* dt_ns and dt are the same time in ns and in s; 0 in the first step. */
void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt,
                  const struct wall_follow_input *in, struct wall_follow_output *out);

/* Rounds dt, in s, to whole ns; ignores the first dt. */
void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct wall_follow_input *in,
                             struct wall_follow_output *out);

#endif
