/* hal/clock.h -- time, as a port supplies it.
 *
 * Times are nanoseconds on a clock that never goes back and that nobody sets;
 * where it starts does not matter. */
#ifndef FROB_HAL_CLOCK_H
#define FROB_HAL_CLOCK_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct frob_clock_operations {
    int64_t (*now_ns)(void *port);

    /* Returns when the clock shows at least `until_ns`, or early. */
    void (*sleep_until)(void *port, int64_t until_ns);
};

struct frob_clock {
    const struct frob_clock_operations *operations;
    void *port;
};

static inline int64_t frob_now_ns(const struct frob_clock *clock)
{
    return clock->operations->now_ns(clock->port);
}

#ifdef __cplusplus
}
#endif
#endif
