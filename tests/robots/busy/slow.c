/* Slow time. When this library is preloaded into the processes of a test, their monotonic clock
 * runs FROB_SLOW times slower than the machine's, and their waits take that much longer. All
 * processes see the same clock, because it has no state. A machine that is too busy for a robot in
 * real time is fast enough for one in slow time; nothing else changes. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <poll.h>
#include <stdint.h>
#include <stdlib.h>
#include <time.h>

static int64_t factor(void)
{
    static int64_t known;
    if (known == 0) {
        const char *text = getenv("FROB_SLOW");
        known = text != NULL && atoi(text) > 0 ? atoi(text) : 1;
    }
    return known;
}

/* The original function of this name, which this library overrides. */
static void *hidden(void **known, const char *name)
{
    if (*known == NULL)
        *known = dlsym(RTLD_NEXT, name);
    return *known;
}

static int64_t to_ns(const struct timespec *time)
{
    return (int64_t)time->tv_sec * 1000000000 + time->tv_nsec;
}

static struct timespec of_ns(int64_t ns)
{
    struct timespec time = { (time_t)(ns / 1000000000), (long)(ns % 1000000000) };
    return time;
}

int clock_gettime(clockid_t clock, struct timespec *time)
{
    static void *known;
    int (*next)(clockid_t, struct timespec *) =
        (int (*)(clockid_t, struct timespec *))hidden(&known, "clock_gettime");
    int result = next(clock, time);
    if (result == 0 && clock == CLOCK_MONOTONIC)
        *time = of_ns(to_ns(time) / factor());
    return result;
}

int clock_nanosleep(clockid_t clock, int flags, const struct timespec *time, struct timespec *left)
{
    static void *known;
    int (*next)(clockid_t, int, const struct timespec *, struct timespec *) =
        (int (*)(clockid_t, int, const struct timespec *, struct timespec *))hidden(
            &known, "clock_nanosleep");
    struct timespec longer = of_ns(to_ns(time) * factor());
    int result = next(clock, flags, &longer, left);
    if (left != NULL && flags == 0)
        *left = of_ns(to_ns(left) / factor());
    return result;
}

int nanosleep(const struct timespec *time, struct timespec *left)
{
    static void *known;
    int (*next)(const struct timespec *, struct timespec *) =
        (int (*)(const struct timespec *, struct timespec *))hidden(&known, "nanosleep");
    struct timespec longer = of_ns(to_ns(time) * factor());
    int result = next(&longer, left);
    if (left != NULL && result != 0)
        *left = of_ns(to_ns(left) / factor());
    return result;
}

int poll(struct pollfd *files, nfds_t count, int wait_ms)
{
    static void *known;
    int (*next)(struct pollfd *, nfds_t, int) =
        (int (*)(struct pollfd *, nfds_t, int))hidden(&known, "poll");
    return next(files, count, wait_ms > 0 ? wait_ms * (int)factor() : wait_ms);
}

int ppoll(struct pollfd *files, nfds_t count, const struct timespec *time, const sigset_t *mask)
{
    static void *known;
    int (*next)(struct pollfd *, nfds_t, const struct timespec *, const sigset_t *) = (int (*)(
        struct pollfd *, nfds_t, const struct timespec *, const sigset_t *))hidden(&known, "ppoll");
    struct timespec longer;
    if (time == NULL)
        return next(files, count, time, mask);
    longer = of_ns(to_ns(time) * factor());
    return next(files, count, &longer, mask);
}
