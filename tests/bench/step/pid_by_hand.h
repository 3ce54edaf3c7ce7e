/* A PID controller with conditional integration and a limited output, as a
 * careful person writes it in C. */
#ifndef PID_BY_HAND_H
#define PID_BY_HAND_H

#include <stdbool.h>

struct pid_by_hand {
    double sum;     /* the integral of the error */
    double counted; /* the error to be integrated over the next step */
    double before;  /* the error one instant ago */
    double slope;   /* its last slope, kept while time stands still */
    bool started;
};

void pid_by_hand_reset(struct pid_by_hand *self);

/* dt in s, not looked at in the first step. */
double pid_by_hand_step(struct pid_by_hand *self, double dt, double error);

#endif
