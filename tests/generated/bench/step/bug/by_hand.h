/* The BUG algorithm as a state machine, as a careful person writes it in C. */
#ifndef BY_HAND_H
#define BY_HAND_H

#include "bug.h"

enum by_hand_state {
    DRIVE,
    LEAVE,   /* round the obstacle, away from where that began */
    RETURN,  /* on, until there again */
    NEAREST, /* on, to the place nearest to the goal */
    REST
};

struct place {
    double x, y;
};

struct by_hand {
    struct place began;      /* where it began to go round */
    struct place nearest;    /* to the goal, since then */
    double nearest_distance; /* from the goal */
    double began_distance;
    double side_before;
    double side_dot;
    double sin_theta_max;
    int64_t since_ns; /* the state's start, where that matters */
    int64_t rest_ns;
    uint8_t state; /* an enum by_hand_state */
    bool started;
    bool seen; /* a wall to the left */
    bool near_before;
};

void by_hand_reset(struct by_hand *self);

/* dt in s, not looked at in the first step. */
void by_hand_step(struct by_hand *self, double dt, const struct bug_input *in,
                  struct bug_output *out);

#endif
