/* sim_clock.h -- the time of a simulator, which publishes it on /clock, as a time that never goes
 * back.
 *
 * A simulator that is restarted sets its time back. Then the program's time stands still for a
 * moment and continues from there: no instant may be before an earlier one. If the simulator's time
 * jumps far ahead, the program does not notice either. */
#ifndef FROB_HOST_ROS_SIM_CLOCK_H
#define FROB_HOST_ROS_SIM_CLOCK_H

#include <stdbool.h>
#include <stdint.h>

struct sim_clock {
    bool started;
    int64_t time_ns;   /* the simulator's newest time */
    int64_t offset_ns; /* the program's time minus the simulator's */
};

/* Handles the next message. Returns the size of a jump in time, which is negative for a jump back;
 * 0 if there was none. */
int64_t sim_clock_take(struct sim_clock *clock, int64_t time_ns);

/* The program's time; meaningless before the first message. */
int64_t sim_clock_now_ns(const struct sim_clock *clock);

#endif
