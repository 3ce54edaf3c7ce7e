#include "hal/posix/clock.h"

#include <time.h>

static int64_t now_ns(void *port)
{
    struct timespec now;
    (void)port;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

static void sleep_until(void *port, int64_t until_ns)
{
    struct timespec until;
    (void)port;
    if (until_ns <= 0)
        return;
    until.tv_sec = (time_t)(until_ns / 1000000000);
    until.tv_nsec = (long)(until_ns % 1000000000);
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, NULL);
}

static const struct frob_clock_operations operations = { now_ns, sleep_until };

const struct frob_clock frob_posix_clock = { &operations, NULL };
