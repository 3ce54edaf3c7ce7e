/* A PID controller with conditional integration and a limited output in C, as a careful
 * programmer would write it. */
#ifndef BY_HAND_H
#define BY_HAND_H

#include "pid.h"

struct by_hand {
    double total;  /* the integral part of the output */
    double growth; /* how fast it grows over the next step */
    double before; /* the last finite error before this instant */
    double since;  /* the time from then to the previous instant */
    double usual;  /* the step counted at the previous instant */
    double slope;  /* the last finite slope, kept while dt is 0 */
    bool known;    /* whether there has been a finite error */
    bool started;
};

void by_hand_reset(struct by_hand *self);

/* dt_ns and dt are the same time in ns and in s; 0 in the first step. */
void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct pid_input *in,
                  struct pid_output *out);

/* Rounds dt, in s, to whole ns. */
void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct pid_input *in,
                             struct pid_output *out);

#endif
