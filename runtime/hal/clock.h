/* hal/clock.h -- the clock that a port supplies.
 *
 * Times are nanoseconds on a monotonic clock that is never set. Its zero is arbitrary. */
#ifndef FROB_HAL_CLOCK_H
#define FROB_HAL_CLOCK_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct frob_clock_operations {
    int64_t (*now_ns)(void *port);

    /* Sleeps until the clock shows at least `until_ns`; it may return early. */
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
