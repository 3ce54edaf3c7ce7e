#include "sim_clock.h"

/* The time has jumped if two messages are further apart than this. */
#define JUMP_NS INT64_C(10000000000)

int64_t sim_clock_take(struct sim_clock *clock, int64_t time_ns)
{
    const int64_t step_ns = clock->started ? time_ns - clock->time_ns : 0;
    clock->started = true;
    clock->time_ns = time_ns;
    if (step_ns >= 0 && step_ns <= JUMP_NS)
        return 0;
    clock->offset_ns -= step_ns;
    return step_ns;
}

int64_t sim_clock_now_ns(const struct sim_clock *clock)
{
    return clock->time_ns + clock->offset_ns;
}
