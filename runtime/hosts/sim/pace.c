#include "pace.h"

#include <errno.h>
#include <string.h>
#include <time.h>

#define LOOK_NS INT64_C(5000000) /* interval between checks for requests while waiting */
/* Above this speed, the simulator waits while more than half of the ring is unread. Otherwise the
 * viewer would miss some instants. */
#define UNSEEN_SPEED 100.0
#define UNSEEN_NS INT64_C(500000)
#define LATE_NS INT64_C(100000000) /* maximum delay that the run makes up for */

static int64_t clock_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

static void sleep_until(const struct pace *pace, int64_t time_ns)
{
    struct timespec until;
    until.tv_sec = (time_t)(time_ns / 1000000000);
    until.tv_nsec = (long)(time_ns % 1000000000);
    while (!*pace->interrupted &&
           clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, NULL) == EINTR)
        continue;
}

void pace_start(struct pace *pace, struct publisher *publisher,
                const volatile sig_atomic_t *interrupted, bool is_free)
{
    memset(pace, 0, sizeof *pace);
    pace->publisher = publisher;
    pace->interrupted = interrupted;
    pace->is_free = is_free;
    pace->speed = 1.0;
    pace->clock_ns = clock_now();
}

/* Restarts pacing at this speed, with `time_ns` as the current time of the run. */
static void begin_again(struct pace *pace, int64_t time_ns, double speed)
{
    pace->clock_ns = clock_now();
    pace->time_ns = time_ns;
    pace->speed = speed;
}

/* Waits until the instant is due. The viewer may change the pace at any time. */
static bool wait_as_wanted(struct pace *pace, int64_t time_ns)
{
    while (!*pace->interrupted && !ring_is_stopped(&pace->publisher->ring)) {
        const int64_t now = clock_now();
        const bool is_heard = publisher_is_heard(pace->publisher, now);
        struct ring_pace wanted = ring_pace(&pace->publisher->ring);
        int64_t due;
        ring_show_alive(&pace->publisher->ring);
        if (!is_heard) {
            wanted.paused = false;
            wanted.speed = 1.0;
        }
        if (wanted.paused) {
            pace->was_paused = true;
            if (wanted.steps != pace->steps) {
                pace->steps++;
                begin_again(pace, time_ns, wanted.speed);
                return true;
            }
            sleep_until(pace, now + LOOK_NS);
            continue;
        }
        pace->steps = wanted.steps;
        if (pace->was_paused || wanted.speed != pace->speed) {
            pace->was_paused = false;
            begin_again(pace, pace->last_ns, wanted.speed);
        }
        due = pace->clock_ns + (int64_t)((double)(time_ns - pace->time_ns) / pace->speed);
        if (now >= due && pace->speed > UNSEEN_SPEED &&
            ring_is_half_unread(&pace->publisher->ring)) {
            sleep_until(pace, now + UNSEEN_NS);
            continue;
        }
        if (now >= due) {
            if (now > due + LATE_NS)
                begin_again(pace, time_ns, pace->speed);
            return true;
        }
        sleep_until(pace, due < now + LOOK_NS ? due : now + LOOK_NS);
    }
    return false;
}

bool pace_wait(struct pace *pace, int64_t time_ns)
{
    const bool looks_on = pace->publisher->ring.shared != NULL;
    if (looks_on && !wait_as_wanted(pace, time_ns))
        return false;
    if (!looks_on && !pace->is_free)
        sleep_until(pace, pace->clock_ns + time_ns);
    pace->last_ns = time_ns;
    return !*pace->interrupted;
}
