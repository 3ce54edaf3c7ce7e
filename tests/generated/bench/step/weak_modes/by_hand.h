/* Follow a wall, back up, turn away, in C, as a careful programmer would write it. A transition takes
 * effect in the next instant. */
#ifndef BY_HAND_H
#define BY_HAND_H

#include "weak_modes.h"

enum by_hand_mode { FOLLOW, BACK_UP, TURN_AWAY };

struct by_hand {
    double side_before;
    double slope;     /* the last slope of the side distance, kept while dt is 0 */
    int64_t since_ns; /* time in this mode, if it needs it */
    uint8_t mode;     /* an enum by_hand_mode */
    bool started;     /* only for by_hand_step_in_seconds */
    bool may_leave;   /* an event in the mode's first instant does not count */
};

void by_hand_reset(struct by_hand *self);

/* dt_ns and dt are the same time in ns and in s; 0 in the first step. */
void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct weak_modes_input *in,
                  struct weak_modes_output *out);

/* Rounds dt, in s, to whole ns; ignores the first dt. */
void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct weak_modes_input *in,
                             struct weak_modes_output *out);

#endif
