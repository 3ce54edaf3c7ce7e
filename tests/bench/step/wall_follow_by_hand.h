/* The wall follower of the Frob paper (section 3), as a careful person writes
 * it in C. */
#ifndef WALL_FOLLOW_BY_HAND_H
#define WALL_FOLLOW_BY_HAND_H

#include <stdbool.h>

struct wall_follow_by_hand {
    double sin_theta_max;
    double s_before; /* the side distance one instant ago */
    double s_dot;    /* its last slope, kept while time stands still */
    bool started;
};

void wall_follow_by_hand_reset(struct wall_follow_by_hand *self);

/* v_curr in m/s, f and s in m; dt in s, not looked at in the first step. */
void wall_follow_by_hand_step(struct wall_follow_by_hand *self, double dt, double v_curr,
                              double f, double s, double *v, double *omega);

#endif
