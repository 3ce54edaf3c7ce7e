/* The wall follower of the Frob paper (section 3), as a careful person writes
 * it in C. */
#ifndef BY_HAND_H
#define BY_HAND_H

#include "wall_follow.h"

struct by_hand {
    double sin_theta_max;
    double s_before; /* the side distance one instant ago */
    double s_dot;    /* its last slope, kept while time stands still */
    bool started;
};

void by_hand_reset(struct by_hand *self);

/* dt in s, not looked at in the first step. */
void by_hand_step(struct by_hand *self, double dt, const struct wall_follow_input *in,
                  struct wall_follow_output *out);

#endif
