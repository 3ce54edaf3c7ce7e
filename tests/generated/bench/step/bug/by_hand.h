/* The BUG algorithm as a state machine in C, as a careful programmer would write it. */
#ifndef BY_HAND_H
#define BY_HAND_H

#include "bug.h"

enum by_hand_state {
    DRIVE,
    LEAVE,   /* around the obstacle, away from the starting point */
    RETURN,  /* on around it, back to the starting point */
    NEAREST, /* on to the place nearest to the goal */
    REST
};

struct place {
    double x, y;
};

struct by_hand {
    struct place began;      /* where the robot began to go around the obstacle */
    struct place nearest;    /* the place nearest to the goal since then */
    double nearest_distance; /* its distance from the goal */
    double began_distance;
    double side_before;
    double side_dot;
    double sin_theta_max;
    int64_t since_ns; /* start of the state, if it needs it */
    int64_t rest_ns;
    uint8_t state; /* an enum by_hand_state */
    bool started;
    bool seen; /* whether there has been a wall on the left */
    bool near_before;
};

void by_hand_reset(struct by_hand *self);

/* dt_ns and dt are the same time in ns and in s; 0 in the first step. */
void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct bug_input *in,
                  struct bug_output *out);

/* Rounds dt, in s, to whole ns. */
void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct bug_input *in,
                             struct bug_output *out);

#endif
