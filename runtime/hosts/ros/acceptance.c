#include "acceptance.h"

#include <stdio.h>
#include <string.h>

#include "device.h"

/* Time without messages after which the driver prints a warning. */
#define SILENCE_NS INT64_C(1000000000)

static double s(int64_t ns)
{
    return (double)ns * 1e-9;
}

/* Reports a message with an implausible timestamp. Reports each kind of fault only once until the
 * clock is set again. */
static void tell_stamp(struct ros_topic *topic, enum stamps_verdict verdict, int64_t by_ns)
{
    if (verdict == STAMPS_GOOD || topic->told[verdict])
        return;
    topic->told[verdict] = true;
    switch (verdict) {
    case STAMPS_OLD:
        fprintf(stderr, "warning: a message on %s arrived %.3f s late; late messages are ignored\n",
                topic->name, s(by_ns));
        break;
    case STAMPS_BACK:
    case STAMPS_AHEAD:
        fprintf(stderr,
                "warning: the timestamp of a message on %s jumped %s by %.3f s; messages are "
                "ignored until timestamps have been regular for a second\n",
                topic->name, verdict == STAMPS_BACK ? "back" : "ahead", s(by_ns));
        break;
    case STAMPS_RESET:
        fprintf(stderr,
                "warning: the clock of the messages on %s was set; they are accepted again\n",
                topic->name);
        memset(topic->told, 0, sizeof topic->told);
        break;
    case STAMPS_GOOD: break;
    }
}

void ros_tell_silence(const struct ros_device *d, struct ros_topic *topic, const char *effect)
{
    const int64_t now = frob_now_ns(&d->clock);
    if (topic->received_ns == INT64_MIN || topic->told_silence ||
        now - topic->received_ns < SILENCE_NS)
        return;
    topic->told_silence = true;
    fprintf(stderr, "warning: no message on %s for %.0f s%s\n", topic->name, s(SILENCE_NS), effect);
}

bool ros_has_sim_time(const struct ros_device *d)
{
    return d->settings[ROS_SIM_TIME] > 0.0;
}

bool ros_accepts(struct ros_device *d, struct ros_topic *topic, const char *bad, int64_t stamp_ns,
                 int64_t arrived_ns, int64_t *taken_ns)
{
    const int64_t late_ns = (int64_t)(d->settings[ROS_LATE] * 1e9);
    enum stamps_verdict verdict;
    int64_t by_ns, clock_ns = arrived_ns;
    topic->received_ns = frob_now_ns(&d->clock);
    topic->told_silence = false;
    if (bad != NULL) {
        if (topic->told_bad != bad)
            fprintf(stderr, "warning: a message on %s is ignored: %s\n", topic->name, bad);
        topic->told_bad = bad;
        return false;
    }
    /* A simulator's clock may run slower than ours, or be stopped. */
    if (ros_has_sim_time(d) && !d->sim_clock.started)
        return false;
    if (ros_has_sim_time(d))
        clock_ns = d->sim_clock.time_ns;
    verdict = stamps_judge(&topic->stamps, stamp_ns, clock_ns, late_ns, &by_ns);
    tell_stamp(topic, verdict, by_ns);
    if (verdict != STAMPS_GOOD && verdict != STAMPS_RESET)
        return false;
    *taken_ns = arrived_ns - (verdict == STAMPS_GOOD ? by_ns : 0);
    return true;
}
