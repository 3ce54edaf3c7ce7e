/* sim_clock.h -- converts the time that a simulator publishes on /clock to a time that never goes
 * back.
 *
 * A simulator's time goes back when the simulator is restarted. In that case, the program's time
 * pauses for a moment and continues from there, because it must not decrease from one instant to
 * the next. If the simulator's time jumps far ahead, the program's time does not jump either. */
#ifndef FROB_HOST_ROS_SIM_CLOCK_H
#define FROB_HOST_ROS_SIM_CLOCK_H

#include <stdbool.h>
#include <stdint.h>

struct sim_clock {
    bool started;
    int64_t time_ns;   /* the simulator's newest time */
    int64_t offset_ns; /* the program's time minus the simulator's */
};

/* Handles the next message. If the time has jumped, returns the size of the jump, which is negative
 * for a jump back; otherwise returns 0. */
int64_t sim_clock_take(struct sim_clock *clock, int64_t time_ns);

/* Returns the program's time, which is valid only after the first message. */
int64_t sim_clock_now_ns(const struct sim_clock *clock);

#endif
