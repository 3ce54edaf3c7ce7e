/* A PID controller with conditional integration and a limited output, as a
 * careful person writes it in C. */
#ifndef BY_HAND_H
#define BY_HAND_H

#include "pid.h"

struct by_hand {
    double sum;     /* the integral of the error */
    double counted; /* the error to be integrated over the next step */
    double before;  /* the error one instant ago */
    double slope;   /* its last slope, kept while time stands still */
    bool started;
};

void by_hand_reset(struct by_hand *self);

/* dt in s, not looked at in the first step. */
void by_hand_step(struct by_hand *self, double dt, const struct pid_input *in,
                  struct pid_output *out);

#endif
